#pragma once
#include "math/Types.h"
#include "tactics/approach/BallApproach.h"

namespace plumbline {

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
BallPath pathToPlace(const Vec2& position, const Vec2& ball, Around side, const BallApproachParameters& p);

}  // namespace plumbline
