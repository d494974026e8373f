#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace plumbline {

// Short names for the algebra used everywhere; doubles, SI units, radians.
using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;
/// Rigid transform; `T_a_b` maps coordinates in b to coordinates in a.
using Pose3 = Eigen::Isometry3d;

/// Pose3 from a translation [m] without rotation.
inline Pose3 translation(const Vec3& t) { return Pose3(Eigen::Translation3d(t)); }
inline Pose3 translation(double x, double y, double z) { return translation(Vec3(x, y, z)); }
/// Pose3 from a rotation about an axis by an angle [rad]; the axis has length 1.
inline Pose3 rotation(const Vec3& axis, double angle) { return Pose3(Eigen::AngleAxisd(angle, axis)); }
inline Pose3 rotationX(double angle) { return rotation(Vec3::UnitX(), angle); }
inline Pose3 rotationY(double angle) { return rotation(Vec3::UnitY(), angle); }
inline Pose3 rotationZ(double angle) { return rotation(Vec3::UnitZ(), angle); }

/// A vector with its length cut to `most`.
inline Vec2 shortened(const Vec2& v, double most) {
  return v.norm() > most ? Vec2(v * (most / v.norm())) : v;
}

}  // namespace plumbline
