#pragma once
#include "math/Types.h"

namespace plumbline::simulation {

// Spatial algebra in world axes about one fixed point, the origin O: a velocity is [linear velocity of the
// body's point at O; angular velocity], an impulse is [impulse; angular impulse about O]. Nothing needs to be
// carried from frame to frame then.
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

inline Mat3 cross(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// An impulse (or force) at a point and an angular one, about O; the point is relative to O.
inline Vec6 spatialImpulse(const Vec3& point, const Vec3& impulse, const Vec3& angular = Vec3::Zero()) {
  Vec6 result;
  result << impulse, angular + point.cross(impulse);
  return result;
}

/// Velocity of a body's point, relative to O.
inline Vec3 velocityAt(const Vec6& velocity, const Vec3& point) {
  return velocity.head<3>() + Vec3(velocity.tail<3>()).cross(point);
}

/// Inertia about O of a body with its centre of mass at this point, inertia in world axes about that.
inline Mat6 spatialInertia(double mass, const Mat3& inertia, const Vec3& point) {
  const Mat3 p = cross(point);
  Mat6 m;
  m.topLeftCorner<3, 3>() = Mat3::Identity() * mass;
  m.topRightCorner<3, 3>() = -mass * p;
  m.bottomLeftCorner<3, 3>() = mass * p;
  m.bottomRightCorner<3, 3>() = inertia - mass * p * p;
  return m;
}

/// Inverse of a symmetric positive definite matrix, by Cholesky.
Mat6 inverseSpd(const Mat6& m);

}  // namespace plumbline::simulation
