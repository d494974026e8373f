#pragma once
#include <cmath>

namespace plumbline {

/// Fastest speed from which steps of `time` [s] can come to rest within a distance, if each takes
/// deceleration * time off it. Distance and speed in m and m/s, or in rad and rad/s.
inline double brakingSpeed(double distance, double deceleration, double time) {
  const double loss = deceleration * time / 2;
  return std::sqrt(loss * loss + 2 * deceleration * distance) - loss;
}

}  // namespace plumbline
