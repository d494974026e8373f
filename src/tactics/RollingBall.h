#pragma once
#include "math/Types.h"

namespace plumbline {

/// SimSpark's ball keeps 97.85 % of its speed per 20 ms: the speed dies away with this time constant [s]. So
/// it rolls as many metres in all as its speed [m/s] times this.
inline constexpr double ballRollingSeconds = 0.92;

/// Where a rolling ball is after some seconds [m, m/s, s]; none of them: where it is.
Vec2 rolledOn(const Vec2& position, const Vec2& velocity, double seconds);

/// Where a rolling ball comes to rest; one that is slower than 0.3 m/s counts as at rest.
Vec2 restingPlace(const Vec2& position, const Vec2& velocity);

/// The first place on a rolling ball's path that a robot, walking at `speed` [m/s], reaches before the ball
/// or together with it, to a tenth of a second. If there is none, the place where the ball stops.
Vec2 meetingPlace(const Vec2& robot, double speed, const Vec2& position, const Vec2& velocity);

}  // namespace plumbline
