#include "History.h"

#include <cstdlib>
#include <filesystem>

#include "framework/FileLines.h"
#include "framework/WriteFile.h"

namespace plumbline::rdb {

namespace {

void append(std::vector<std::string>& lines, const std::string& line) {
  if (line.empty() || (!lines.empty() && lines.back() == line)) return;
  lines.push_back(line);
  if (lines.size() > History::most) lines.erase(lines.begin());
}

std::vector<std::string> readLines(const std::string& path) {
  std::vector<std::string> lines;
  if (!std::filesystem::exists(path)) return lines;
  FileLines in(path);
  for (std::string line; in.next(line);) append(lines, line);
  return lines;
}

}  // namespace

History::History(std::string path) : path_(std::move(path)), lines_(readLines(path_)) {}

std::string History::standardPath() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  if (state && state[0] == '/') return std::string(state) + "/plumbline/rdb_history";
  return home && *home ? std::string(home) + "/.local/state/plumbline/rdb_history" : "";
}

void History::add(const std::string& line) {
  append(lines_, line);
  append(typed_, line);
}

std::string History::save() const {
  if (path_.empty() || typed_.empty()) return {};
  try {
    std::filesystem::create_directories(std::filesystem::path(path_).parent_path());
    std::string text;
    std::vector<std::string> lines = readLines(path_);
    for (const std::string& line : typed_) append(lines, line);
    for (const std::string& line : lines) text += line + '\n';
    writeFile(path_, text);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace plumbline::rdb
