#pragma once
#include <vector>

#include "math/Types.h"
#include "parameters/Parameter.h"

namespace plumbline {

struct ChargeGuardParameters {
  PARAMETERS(ChargeGuardParameters)
  PARAMETER(double, contactDistance, 0.3, "m", Range(0, 2), "distance of two robots' middles when they touch")
  PARAMETER(double, contactSeconds, 0.5, "s", Range(0.02, 5),
            "until it would touch an opponent, at the fastest speed towards it that is allowed")
  PARAMETER(double, leastSpeed, 0.1, "m/s", Range(0, 1), "towards an opponent that is always allowed")
  PARAMETER(double, nearerBy, 0.05, "m", Range(0, 1), "an opponent nearer to the ball by this has it")
  PARAMETER(double, touchDistance, 0.16, "m", Range(0, 1), "a ball this near to the robot is being touched")
  PARAMETER(double, immunity, 0.7, "s", Range(0, 10), "after a touch everything is allowed")
  PARAMETER(double, widestAngle, 1.2, "rad", Range(0, 3.2),
            "opponents farther off the way than this do not matter")
};

/// Keeps a robot from charging: by the league's rules it must not run into an opponent that is nearer to the
/// ball, unless it has just touched the ball itself.
class ChargeGuard {
public:
  /// A cycle of dt [s]. velocity: wanted [m/s]; ball and opponents (those that stand): all in the robot's
  /// ground frame [m]. Returns the velocity with less of it towards opponents, where that is needed.
  Vec2 allowed(Vec2 velocity, const Vec2& ball, const std::vector<Vec2>& opponents,
               const ChargeGuardParameters& p, double dt);

private:
  double sinceTouch_ = 1e3;  ///< time since it touched the ball; at first long ago [s]
};

}  // namespace plumbline
