#pragma once
#include "math/Pose2.h"

namespace plumbline {

/// Speed limits and gains of walking to a pose. Speeds in m/s and rad/s, gains in 1/s.
struct WalkToPoseParameters {
  double maxForward = 0.5, maxBackward = 0.3, maxSideways = 0.2, maxTurn = 1.5;
  double positionGain = 1.5;  ///< speed per metre to go
  double headingGain = 2.0;   ///< turn per radian to go
  double nearDistance =
      0.6;  ///< closer than this the robot keeps its final heading and walks in any direction [m]
  double turnFirst = 1.0;  ///< a target further off than this angle is turned to before walking [rad]
};

/// A walk request in the robot's frame [m/s, rad/s].
struct WalkCommand {
  Vec2 velocity = Vec2::Zero();
  double turn = 0;
};

/// The walk that brings the robot to a pose given in its own frame: far away it faces the way it goes, near
/// the target it takes the final heading. Speeds never exceed the limits (an ellipse for forward and
/// sideways).
WalkCommand walkToPose(const Pose2& T_robot_target, const WalkToPoseParameters& parameters);

/// Scales a velocity back onto the ellipse of the limits, keeping its direction.
Vec2 limitVelocity(const Vec2& velocity, const WalkToPoseParameters& parameters);

}  // namespace plumbline
