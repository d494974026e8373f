#pragma once
#include <cmath>

#include "math/Types.h"

namespace plumbline {

/// The shortest turn from one direction to another (vectors of length 1), as a rotation vector [rad].
inline Vec3 turnBetween(const Vec3& from, const Vec3& to) {
  const Vec3 across = from.cross(to);
  const double sine = across.norm(), angle = std::atan2(sine, from.dot(to));
  return sine > 0 ? Vec3(across * (angle / sine)) : Vec3(angle * from.unitOrthogonal());
}

}  // namespace plumbline
