#include "modules/motion/Motions.h"

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>

#include "framework/ConfigurationError.h"
#include "framework/ReadFile.h"
#include "motion/KeyframeReader.h"

namespace plumbline {

namespace {
constexpr std::size_t mostBytes = 1 << 20;  // of a file

/// All that motions depend on.
struct MotionSources {
  std::vector<std::filesystem::path> directories;
  std::vector<std::pair<std::filesystem::path, std::string>> files;      ///< path, text
  std::string robot;                                                     ///< its name
  std::vector<std::tuple<JointId, std::string, double, double>> joints;  ///< name, limits
  bool operator==(const MotionSources&) const = default;
};

/// Nothing where a file cannot be read: who parses it says why.
std::optional<MotionSources> sourcesOf(const std::vector<std::filesystem::path>& directories,
                                       const RobotModel& robot) {
  MotionSources sources{directories, {}, robot.name, {}};
  try {
    for (const auto& [name, path] : motion::motionFiles(directories))
      sources.files.emplace_back(path, readFile(path.string(), mostBytes));
  } catch (const FileProblem&) {
    return std::nullopt;
  }
  for (const JointId joint : robot.joints()) {
    const Link& link = robot.linkMovedBy(joint);
    sources.joints.emplace_back(joint, robot.jointName(joint), link.lower, link.upper);
  }
  return sources;
}

/// A player's modules read the same motions one after the other, and a text takes long to parse.
std::vector<motion::KeyframeMotion> readOnce(const std::vector<std::filesystem::path>& directories,
                                             const RobotModel& robot) {
  static std::mutex mutex;
  static std::optional<MotionSources> last;
  static std::vector<motion::KeyframeMotion> motions;
  const std::lock_guard lock(mutex);
  std::optional<MotionSources> sources = sourcesOf(directories, robot);
  if (sources && sources == last) return motions;
  last.reset();
  motions = motion::readMotions(directories, robot);
  last = std::move(sources);
  return motions;
}

}  // namespace

std::vector<motion::KeyframeMotion> readMotions(const Config& config, const RobotModel& robot) {
  std::vector<std::filesystem::path> directories;
  for (const std::string& directory : config.directories())
    directories.push_back(std::filesystem::path(directory) / "motions");
  try {
    return readOnce(directories, robot);
  } catch (const motion::KeyframeFileError& error) {
    throw ConfigurationError(error.what());
  }
}

}  // namespace plumbline
