#pragma once
#include <vector>

#include "framework/Config.h"
#include "motion/Keyframes.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// The keyframe motions in the directory motions/ of each configuration directory; a robot's own directory
/// overrides single motions. Throws ConfigurationError for a file that cannot be used.
std::vector<motion::KeyframeMotion> readMotions(const Config& config, const RobotModel& robot);

}  // namespace plumbline
