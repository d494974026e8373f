#pragma once
#include "math/Types.h"
#include "parameters/Parameter.h"

namespace plumbline {

/// How far from the ball a robot walks around it.
struct BallPathParameters {
  PARAMETERS(BallPathParameters)
  PARAMETER(double, avoidRadius, 0.26, "m", Range(0.1, 2),
            "distance kept from the ball while walking around it")
  PARAMETER(double, stepAngle, 0.25, "rad", Range(0.05, 1.5),
            "how far ahead on the circle around the ball the next way point lies")
  PARAMETER(double, behindAngle, 0.53, "rad", Range(0.05, 1.5),
            "within this angle of the line through ball and target the robot may close in")
};

/// On which side of the ball a robot goes around it, seen from above.
enum class Around { clockwise, counterclockwise };

/// The way that is left.
struct BallPath {
  Vec2 next = Vec2::Zero();  ///< where to go now [m]
  double length = 0;         ///< of the whole way [m]
  bool last = false;         ///< nothing but the place itself is left
};

/// The way from a position to the origin, which is the place beside the ball. It is straight if the ball is
/// not in the way. Else it goes by a tangent to the circle around the ball, and along that. All in one frame
/// [m].
BallPath pathToPlace(const Vec2& position, const Vec2& ball, Around side, const BallPathParameters& p);

}  // namespace plumbline
