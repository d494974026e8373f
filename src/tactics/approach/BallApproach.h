#pragma once
#include "math/Pose2.h"
#include "parameters/Parameter.h"

namespace plumbline {

/// Where a robot goes to stand at the ball with a given heading without touching the ball on the way.
struct BallApproachParameters {
  PARAMETERS(BallApproachParameters)
  PARAMETER(double, avoidRadius, 0.30, "m", Range(0.1, 2),
            "distance kept from the ball while walking around it")
  PARAMETER(double, stepAngle, 0.9, "rad", Range(0.1, 1.5),
            "how far ahead on the circle around the ball the next way point lies")
  PARAMETER(double, behindAngle, 0.5, "rad", Range(0.1, 1.5),
            "within this angle of the line through ball and target the robot may close in")
};

/// The next way point in the robot's frame. `ball`: the ball relative to the robot [m]; `heading`: wanted
/// heading relative to the robot's [rad]; `ballInTarget`: where the ball has to lie in the robot's frame when
/// it has arrived [m]. Way points on the circle face the ball; the last pose has the wanted heading.
Pose2 approachBall(const Vec2& ball, double heading, const Vec2& ballInTarget,
                   const BallApproachParameters& parameters);

}  // namespace plumbline
