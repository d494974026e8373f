#pragma once
#include <algorithm>

#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// The turn of a walk that is to stop. It goes on as requested for a moment, so that a robot which stops
/// somewhere also gets its heading right. After that it ends, or the feet would never come side by side.
class TurnToStop {
public:
  /// The turn to walk with [rad/s]; walks: the robot is not to stop.
  double turn(double requested, bool walks, const WalkParameters& p, double dt) {
    constexpr double longest = 0.5;  // [s]
    stopping_ = walks ? 0 : stopping_ + dt;
    if (walks) return requested;
    const double most = stopping_ < longest ? p.startStop.turn : 0;
    return std::clamp(requested, -most, most);
  }

private:
  double stopping_ = 0;  ///< since it is to stop, or to stand [s]
};

}  // namespace plumbline::walking
