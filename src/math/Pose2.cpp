#include "math/Pose2.h"

namespace plumbline {

Mat2 Pose2::rotation() const { return Eigen::Rotation2Dd(heading).toRotationMatrix(); }

Pose2 Pose2::operator*(const Pose2& other) const {
  return Pose2(position + rotation() * other.position, normalizeAngle(heading + other.heading));
}

Vec2 Pose2::operator*(const Vec2& point) const { return position + rotation() * point; }

Pose2 Pose2::inverse() const {
  return Pose2(Vec2(-(rotation().transpose() * position)), normalizeAngle(-heading));
}

}  // namespace plumbline
