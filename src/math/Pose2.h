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
  Mat2 rotation() const;

  /// T_a_c from T_a_b (this) and T_b_c.
  Pose2 operator*(const Pose2& other) const;
  /// A point of b in coordinates of a.
  Vec2 operator*(const Vec2& point) const;
  Pose2 inverse() const;
};

}  // namespace plumbline
