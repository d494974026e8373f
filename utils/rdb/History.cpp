#include "History.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "framework/WriteFile.h"

namespace plumbline::rdb {

History::History(std::string path) : path_(std::move(path)) {
  std::ifstream in(path_);
  for (std::string line; std::getline(in, line) && lines_.size() < 100 * most;) add(line);
}

std::string History::standardPath() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  if (state && state[0] == '/') return std::string(state) + "/plumbline/rdb_history";
  return home && *home ? std::string(home) + "/.local/state/plumbline/rdb_history" : "";
}

void History::add(const std::string& line) {
  if (line.empty() || (!lines_.empty() && lines_.back() == line)) return;
  lines_.push_back(line);
  if (lines_.size() > most) lines_.erase(lines_.begin());
}

std::string History::save() const {
  if (path_.empty()) return {};
  try {
    std::filesystem::create_directories(std::filesystem::path(path_).parent_path());
    std::string text;
    for (const std::string& line : lines_) text += line + '\n';
    writeFile(path_, text);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace plumbline::rdb
