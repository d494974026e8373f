#pragma once
#include "math/Pose2.h"

namespace plumbline {

/// Where a robot goes to stand at the ball with a given heading without touching the ball on the way.
struct BallApproachParameters {
  double avoidRadius = 0.30;  ///< kept from the ball while walking around it [m]
  double stepAngle = 0.9;     ///< how far ahead on the circle the next way point lies [rad]
  double behindAngle = 0.5;   ///< within this angle of the line through ball and target it may close in [rad]
};

/// The next way point in the robot's frame. `ball`: the ball relative to the robot [m]; `heading`: wanted
/// heading relative to the robot's [rad]; `ballInTarget`: where the ball has to lie in the robot's frame when
/// it has arrived [m]. Way points on the circle face the ball; the last pose has the wanted heading.
Pose2 approachBall(const Vec2& ball, double heading, const Vec2& ballInTarget,
                   const BallApproachParameters& parameters);

}  // namespace plumbline
