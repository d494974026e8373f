#include "game/OutputFolder.h"

#include <filesystem>
#include <stdexcept>

#include "framework/ConfigFolder.h"
#include "framework/WriteFile.h"

namespace plumbline::game {

namespace fs = std::filesystem;

namespace {

/// As much as the logs of a short run: a disk that is nearly full is noticed before anything starts.
constexpr std::size_t probeBytes = 64 << 10;

}  // namespace

std::string defaultOutput() {
  const fs::path programs = programFolder();
  for (const char* root : {"..", "../../.."}) {
    std::error_code error;
    if (!fs::is_directory(programs / root / "config", error)) continue;
    const fs::path project = fs::weakly_canonical(programs / root), folder = project / "build/run";
    const fs::path near = folder.lexically_proximate(fs::current_path(error));
    return near.begin() != near.end() && *near.begin() == ".." ? folder.string() : near.string();
  }
  return "build/run";
}

void prepareOutput(const std::string& folder, const std::vector<std::string>& files) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error("cannot write to " + folder + ": " + why + "; give --output another folder");
  };
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) refuse(error.message());
  for (const std::string& file : files) {
    fs::remove(fs::path(folder) / file, error);
    if (error) refuse(error.message());
  }
  const std::string probe = folder + "/probe";
  try {
    writeFile(probe, std::string(probeBytes, '\n'));
  } catch (const std::runtime_error& problem) {
    const std::string text = problem.what(), begin = "cannot write " + probe + ": ";
    fs::remove(probe, error);
    refuse(text.starts_with(begin) ? text.substr(begin.size()) : text);
  }
  fs::remove(probe, error);
}

}  // namespace plumbline::game
