#pragma once
#include <cmath>

#include "math/Angle.h"

namespace plumbline::walking {

/// The swing foot's path in a step that kicks (section 4.4.1: a kick as a walk action). In addition to its
/// path from lift-off to target, the foot moves back and then fast forward, along the support foot's x axis.
struct KickStep {
  double back = 0.04;     ///< [m]
  double forward = 0.09;  ///< [m]
  double drawn = 0.35;    ///< phase at which it is farthest back
  double thrown = 0.62;   ///< phase at which it is farthest in front

  /// Added to the swing foot's x [m]; phase 0 .. 1.
  double offset(double phase) const {
    const auto between = [](double from, double to, double share) {
      return from + (to - from) * 0.5 * (1 - std::cos(pi * share));
    };
    if (phase <= 0 || phase >= 1) return 0;
    if (phase < drawn) return between(0, -back, phase / drawn);
    if (phase < thrown) return between(-back, forward, (phase - drawn) / (thrown - drawn));
    return between(forward, 0, (phase - thrown) / (1 - thrown));
  }
};

}  // namespace plumbline::walking
