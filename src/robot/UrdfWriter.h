#pragma once
#include <string>

#include "robot/RobotModel.h"

namespace plumbline {

/// The model as a URDF: links with mass, inertia and shape, joints with limits (effort 0: unknown). A rigid
/// link without a joint is fixed to its parent.
std::string urdfOf(const RobotModel& model);

}  // namespace plumbline
