#pragma once
#include <vector>

#include "framework/Config.h"
#include "motion/Keyframes.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// The keyframe motions in the directory motions/ of each configuration directory; a robot's own directory
/// overrides single motions. Throws ConfigurationError for a file that cannot be used.
std::vector<motion::KeyframeMotion> readMotions(const Config& config, const RobotModel& robot);

/// Counts cycles in which the torso does not turn, for motions that wait until the robot has settled.
class Stillness {
public:
  /// gyro: turn rate of the torso [rad/s]. True once it has been small for some cycles.
  bool update(const Vec3& gyro);

private:
  int cycles_ = 0;
};

}  // namespace plumbline
