#pragma once
#include <algorithm>

#include "math/Types.h"
#include "robot/WalkLimits.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

// Speeds as (forward, sideways, turn) [m/s, m/s, rad/s]; limits are for the direction of `forward`.

/// Up to where any mixture of directions may be asked for.
inline Vec3 omniLimits(double forward, const WalkParameters& p) {
  const auto within = [](double omni, double most) { return omni > 0 ? std::min(omni, most) : most; };
  const SpeedParameters& s = p.speed;
  return {forward < 0 ? within(s.omniBackward, s.maxBackward) : within(s.omniForward, s.maxForward),
          within(s.omniSideways, s.maxSideways), within(s.omniTurn, s.maxTurn)};
}

/// What the walk makes of requests of mixtures, for who plans ahead.
inline WalkLimits walkLimits(const WalkParameters& p) {
  const Vec3 forward = omniLimits(1, p);
  return {.forward = forward.x(),
          .backward = omniLimits(-1, p).x(),
          .sideways = forward.y(),
          .turn = forward.z(),
          .accelerationForward = p.speed.accelerationForward,
          .decelerationForward = p.speed.decelerationForward,
          .accelerationSideways = p.speed.accelerationSideways,
          .accelerationTurn = p.speed.accelerationTurn};
}

/// Those of one direction alone.
inline Vec3 fullLimits(double forward, const WalkParameters& p) {
  return {forward < 0 ? p.speed.maxBackward : p.speed.maxForward, p.speed.maxSideways, p.speed.maxTurn};
}

/// How much of a speed is off an axis, as a share of the limits.
inline double shareOffAxis(const Vec3& speed, const Vec3& limits, int axis) {
  Vec3 others = speed.cwiseQuotient(limits);
  others[axis] = 0;
  return others.norm();
}

/// Scaled into the limits' ellipsoid.
inline Vec3 withinEllipsoid(const Vec3& speed, const Vec3& limits) {
  return speed / std::max(1.0, speed.cwiseQuotient(limits).norm());
}

}  // namespace plumbline::walking
