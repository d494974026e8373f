#pragma once
#include <cmath>
#include <numbers>

namespace plumbline {

constexpr double pi = std::numbers::pi;

constexpr double fromDegrees(double degrees) { return degrees * (pi / 180.0); }
constexpr double toDegrees(double radians) { return radians * (180.0 / pi); }

/// The same angle in (-pi, pi] [rad].
inline double normalizeAngle(double angle) {
  if (angle > -pi && angle <= pi) return angle;
  // One turn away. Such a difference is exact, so it is the remainder, a zero with its sign, in less time.
  constexpr double oneTurn = 9;  // less than 3 pi
  if (std::abs(angle) < oneTurn && std::abs(angle) != pi)
    return angle > 0 ? angle - 2.0 * pi : -(-angle - 2.0 * pi);
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? pi : wrapped;
}

}  // namespace plumbline
