#pragma once
#include "math/Pose2.h"
#include "robot/WalkLimits.h"

namespace plumbline {

/// A walking robot in any frame of the ground: where it is, and its speed forward, sideways and of the turn
/// in its own frame [m/s, m/s, rad/s].
struct WalkPoint {
  Pose2 pose;
  Vec3 speed = Vec3::Zero();
};

/// Where the robot is after `seconds` at its present speed.
WalkPoint coasted(WalkPoint point, double seconds);

/// What the walk makes of a request (forward, sideways, turn) in `seconds`, as walking::SpeedControl does. It
/// scales the request into its limits and follows it as fast as it may. What speed forward leaves of the
/// limits bounds the other two. Sprints are left out.
WalkPoint walked(WalkPoint point, const Vec3& request, const WalkLimits& limits, double seconds);

}  // namespace plumbline
