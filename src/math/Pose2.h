#pragma once
#include "math/Angle.h"
#include "math/Types.h"

namespace plumbline {

/// Position [m] and heading [rad, counterclockwise] in a plane. As a transform T_a_b it maps b's points to
/// a's.
struct Pose2 {
  Vec2 position = Vec2::Zero();
  double heading = 0;

  Pose2() = default;
  Pose2(double x, double y, double heading = 0) : position(x, y), heading(heading) {}
  explicit Pose2(const Vec2& position, double heading = 0) : position(position), heading(heading) {}

  double x() const { return position.x(); }
  double y() const { return position.y(); }
  Mat2 rotation() const { return Eigen::Rotation2Dd(heading).toRotationMatrix(); }

  /// T_a_c from T_a_b (this) and T_b_c.
  Pose2 operator*(const Pose2& other) const {
    return Pose2(position + rotation() * other.position, normalizeAngle(heading + other.heading));
  }
  /// A point of b in coordinates of a.
  Vec2 operator*(const Vec2& point) const { return position + rotation() * point; }
  Pose2 inverse() const {
    return Pose2(Vec2(-(rotation().transpose() * position)), normalizeAngle(-heading));
  }
};

}  // namespace plumbline
