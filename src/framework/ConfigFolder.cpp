#include "framework/ConfigFolder.h"

#include <filesystem>
#include <system_error>

#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

std::string& givenFolder() {
  static std::string folder;
  return folder;
}

bool isConfiguration(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "platforms", error);
}

/// Paths in messages are short if the program is started from near its folder.
std::string nearPath(const fs::path& path) {
  std::error_code error;
  const fs::path shorter = fs::proximate(path, error);
  return error || shorter.string().starts_with("../../..") ? path.lexically_normal().string()
                                                           : shorter.string();
}

}  // namespace

std::string programFolder() {
  std::error_code error;
  const fs::path path = fs::read_symlink("/proc/self/exe", error);
  return error ? std::string(".") : path.parent_path().string();
}

std::string configFolder() {
  if (!givenFolder().empty()) return givenFolder();
  if (isConfiguration("config")) return "config";
  const fs::path programs = programFolder();
  // bin/; build/TARGET/bin/ and build/TARGET/tests/; what is installed.
  for (const char* place : {"../config", "../../../config", "../share/plumbline"})
    if (isConfiguration(programs / place)) return nearPath(programs / place);
  return "config";
}

std::string configPath(const std::string& name) { return (fs::path(configFolder()) / name).string(); }

void useConfigFolder(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw ConfigurationError("--config " + folder + ": there is no such folder");
  givenFolder() = folder;
}

}  // namespace plumbline
