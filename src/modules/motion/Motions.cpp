#include "modules/motion/Motions.h"

#include <filesystem>

#include "framework/ConfigurationError.h"
#include "motion/KeyframeReader.h"

namespace plumbline {

namespace {
constexpr double stillTurnRate = 0.3;  // [rad/s]
constexpr int stillCycles = 3;
}  // namespace

std::vector<motion::KeyframeMotion> readMotions(const Config& config, const RobotModel& robot) {
  std::vector<std::filesystem::path> directories;
  for (const std::string& directory : config.directories())
    directories.push_back(std::filesystem::path(directory) / "motions");
  try {
    return motion::readMotions(directories, robot);
  } catch (const motion::KeyframeFileError& error) {
    throw ConfigurationError(error.what());
  }
}

bool Stillness::update(const Vec3& gyro) {
  cycles_ = gyro.norm() < stillTurnRate ? cycles_ + 1 : 0;
  return cycles_ >= stillCycles;
}

}  // namespace plumbline
