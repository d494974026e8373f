#pragma once
#include <array>
#include <cstddef>

#include "math/Types.h"

namespace plumbline {

/// The ground as seen: the plane through points that lie on it (ends of field lines, corner flags), by least
/// squares; points and results in one frame, whatever it is turned like.
class GroundPlane {
public:
  static constexpr std::size_t maxPoints = 64;

  void clear() { count_ = 0; }
  /// A point on the ground [m] and the variance of its height [m^2]; those beyond maxPoints are left out.
  void add(const Vec3& point, double variance);

  struct Fit {
    Vec3 up = Vec3::UnitZ();                   ///< normal of the plane, on the eye's side
    std::array<Vec3, 2> axes;                  ///< directions in the plane, the better known one first
    std::array<double, 2> variances = {1, 1};  ///< of the normal's tilt towards each axis [rad^2]
  };
  /// False if the points are too few or on one line, or do not lie on a plane. eye: a point above the ground.
  bool fit(const Vec3& eye, Fit& result) const;

private:
  std::array<Vec3, maxPoints> points_;
  std::array<double, maxPoints> weights_;
  std::size_t count_ = 0;
};

}  // namespace plumbline
