#pragma once
#include "math/Types.h"

namespace plumbline {

/// To which side a robot turns that has lost the ball: away from where it believed it, as its head does
/// (SimpleHeadMotion). The ball is not there, and a head that looks to the other side than the body turns to
/// sees little that is new.
class BallSearch {
public:
  /// In each cycle without a ball; believed: where it was, in the robot's frame [m]; now [s]. How far the
  /// robot is to turn from its present heading [rad].
  double turn(const Vec2& believed, double now) {
    if (last_ < 0 || now < last_ || now - last_ > interrupted) side_ = sideAwayFrom(believed);
    last_ = now;
    return side_ * step;
  }
  /// +1 left, -1 right.
  static double sideAwayFrom(const Vec2& believed) { return believed.y() > 0 ? -1 : 1; }

private:
  static constexpr double interrupted = 0.1;  // cycles in a row are of one search [s]
  static constexpr double step = 1;           // far enough that the robot turns fast [rad]

  double side_ = 1, last_ = -1;
};

}  // namespace plumbline
