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

// Not inline: each source that includes this would compile them, and Eigen's classes behind them, once more.

/// Pose3 from a translation [m] without rotation.
Pose3 translation(const Vec3& t);
Pose3 translation(double x, double y, double z);
/// Pose3 from a rotation about an axis by an angle [rad]; the axis has length 1.
Pose3 rotation(const Vec3& axis, double angle);
Pose3 rotationX(double angle);
Pose3 rotationY(double angle);
Pose3 rotationZ(double angle);

/// A vector with its length cut to `most`.
Vec2 shortened(const Vec2& v, double most);

}  // namespace plumbline
