#pragma once

namespace plumbline {

/// SimSpark's ball keeps 97.85 % of its speed per 20 ms: the speed dies away with this time constant [s]. So
/// it rolls as many metres in all as its speed [m/s] times this.
inline constexpr double ballRollingSeconds = 0.92;

}  // namespace plumbline
