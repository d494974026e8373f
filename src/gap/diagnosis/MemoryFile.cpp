#include "gap/diagnosis/MemoryFile.h"

#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>

#include "framework/Json.h"
#include "framework/ReadFile.h"
#include "framework/WriteFile.h"
#include "gap/diagnosis/MarkDump.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostBytes = std::size_t{64} << 20;

std::string sumOf(const nlohmann::json& content) {
  MarkDump dump;
  dump.add(content.dump());
  return dump.text();
}

}  // namespace

MemoryFile::MemoryFile(std::string path, std::string mark, Warn warn)
    : path_(std::move(path)), mark_(std::move(mark)), warn_(std::move(warn)) {}

void MemoryFile::warn(const std::string& text) const {
  if (warn_) warn_(text);
}

bool MemoryFile::read(const std::function<void(const nlohmann::json&)>& take) const {
  std::error_code none;
  if (path_.empty() || !std::filesystem::is_regular_file(path_, none)) return false;
  constexpr const char* anew = "; the diagnosis begins anew";
  try {
    const nlohmann::json stored = parseJson(readFile(path_, mostBytes), {.bytes = mostBytes});
    if (stored.at("mark") != mark_) {
      warn(path_ + ": is of other recordings, other options or another version of the program" + anew);
      return false;
    }
    const nlohmann::json& content = stored.at("content");
    if (stored.at("sum") != sumOf(content)) throw std::invalid_argument("another sum");
    take(content);
    return true;
  } catch (const std::bad_alloc&) {
    throw;  // the file may be good
  } catch (const FileProblem& problem) {
    warn(path_ + ": " + problem.what() + anew);
  } catch (const std::exception&) {
    warn(path_ + ": is damaged" + anew);
  }
  return false;
}

bool MemoryFile::write(const nlohmann::json& content) {
  if (path_.empty() || !writable_) return false;
  try {
    writeFile(path_, nlohmann::json{{"mark", mark_}, {"sum", sumOf(content)}, {"content", content}}.dump());
    return true;
  } catch (const std::runtime_error& error) {
    // Only time is lost where the diagnosis is stopped later.
    writable_ = false;
    warn(std::string(error.what()) + "; a diagnosis that is stopped from now on repeats what follows");
    return false;
  }
}

void MemoryFile::forget() const {
  std::error_code none;
  if (!path_.empty() && std::filesystem::is_regular_file(path_, none)) std::filesystem::remove(path_, none);
}

}  // namespace plumbline::gap
