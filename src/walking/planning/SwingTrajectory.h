#pragma once
#include <algorithm>
#include <cmath>

#include "math/Angle.h"
#include "math/Pose2.h"

namespace plumbline::walking {

/// Path of the swing foot over its step, phase 0 .. 1.
struct SwingTrajectory {
  double height = 0.02;     ///< [m]
  double start = 0;         ///< phase when it begins to move over the ground
  double end = 1;           ///< phase when it has arrived
  double smoothness = 0.5;  ///< 0: constant speed over the ground, 1: from rest to rest
  double steepness = 1.5;   ///< of lifting and lowering: 1 a sine arch, 2 from rest to rest

  /// Covered share of the way over the ground.
  double share(double phase) const {
    const double t = std::clamp((phase - start) / (end - start), 0.0, 1.0);
    return (1 - smoothness) * t + smoothness * 0.5 * (1 - std::cos(pi * t));
  }
  /// Share of the full height.
  double lift(double phase) const {
    return std::pow(std::max(0.0, std::sin(pi * std::clamp(phase, 0.0, 1.0))), steepness);
  }
  /// The foot on its way from one pose to the other.
  Pose2 between(const Pose2& from, const Pose2& to, double phase) const {
    const double s = share(phase);
    return Pose2(Vec2(from.position + s * (to.position - from.position)),
                 from.heading + s * normalizeAngle(to.heading - from.heading));
  }
};

}  // namespace plumbline::walking
