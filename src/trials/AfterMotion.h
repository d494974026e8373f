#pragma once
#include <cmath>

#include "math/Angle.h"
#include "math/Types.h"

namespace plumbline {

/// What shows whether a robot can go on after a motion: a walk into a random direction with a random turn
/// (Seekircher 2015, 3.1.1). Or it stands still instead, in a share of the runs.
struct AfterMotion {
  static constexpr double walkSpeed = 0.3, walkTurn = 0.5;  ///< of a walk, its largest turn [m/s, rad/s]
  static constexpr double leaning = 30 * pi / 180;          ///< of the thesis's measure [rad]

  Vec2 velocity = Vec2::Zero();  ///< [m/s]
  double turn = 0;               ///< [rad/s]
  bool stands = false;

  /// random(low, high) is uniform; still: the share of the runs in which it stands.
  template <typename Uniform>
  static AfterMotion drawn(Uniform&& random, double still) {
    AfterMotion after;
    const double way = random(-pi, pi);
    after.turn = random(-walkTurn, walkTurn);
    after.velocity = walkSpeed * Vec2(std::cos(way), std::sin(way));
    after.stands = still > 0 && random(0, 1) < still;
    return after;
  }
  /// Of a torso that is tilted so [rad].
  static bool upright(double tilt) { return tilt < leaning; }
};

}  // namespace plumbline
