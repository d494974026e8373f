#pragma once
#include <cmath>
#include <numbers>

namespace plumbline {

constexpr double pi = std::numbers::pi;

constexpr double fromDegrees(double degrees) { return degrees * (pi / 180.0); }
constexpr double toDegrees(double radians) { return radians * (180.0 / pi); }

/// The same angle in (-pi, pi] [rad].
inline double normalizeAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? pi : wrapped;
}

}  // namespace plumbline
