#include "simspark/LeagueRecording.h"

#include <map>
#include <stdexcept>

namespace plumbline::simspark {

namespace fs = std::filesystem;

std::vector<LeagueTrace> readLeagueRecording(const fs::path& file) {
  const TraceName own = traceName(file);
  std::map<int, fs::path> files{{own.robot.value_or(1), file}};
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code unreadable;  // reading the file itself says what is wrong with its folder
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable)) {
    const fs::path& other = entry.path();
    const TraceName name = traceName(other);
    const int robot = name.robot.value_or(1);
    if (name.name == other.filename() || name.recording != own.recording || robot == own.robot.value_or(1))
      continue;
    if (const auto [known, isNew] = files.emplace(robot, other); !isNew)
      throw std::runtime_error(folder.string() + ": robot " + std::to_string(robot) + " of " + own.recording +
                               " is in two files; move one of them away");
  }
  std::vector<LeagueTrace> robots;
  for (const auto& [robot, path] : files) {
    robots.push_back(readLeagueTrace(path));
    if (robots.back().rows.size() != robots.front().rows.size())
      throw std::runtime_error(path.string() + ": has " + std::to_string(robots.back().rows.size()) +
                               " rows, " + files.begin()->second.string() + " has " +
                               std::to_string(robots.front().rows.size()) +
                               "; robots of one recording have as many");
  }
  return robots;
}

}  // namespace plumbline::simspark
