#pragma once
#include <algorithm>
#include <cmath>

#include "math/Gravity.h"
#include "math/Types.h"

namespace plumbline {

/// Roll and pitch of the torso from gyro and accelerometer: the gravity direction is turned by the gyro and
/// drawn slowly to the measured acceleration while that has about the size of gravity (complementary filter).
class TorsoAngleFilter {
public:
  /// accelerometerShare: weight of one measurement of the accelerometer, 0 .. 1.
  explicit TorsoAngleFilter(double accelerometerShare = 0.002) : share_(accelerometerShare) {}

  /// gyro [rad/s] and acc [m/s^2, specific force, (0,0,9.81) at rest] in the torso frame; dt [s].
  void update(const Vec3& gyro, const Vec3& acc, double dt) {
    const double angle = gyro.norm() * dt;
    if (angle > 0) up_ = Eigen::AngleAxisd(-angle, gyro.normalized()) * up_;
    const double size = acc.norm();
    const double trust = std::max(0.0, 1 - std::abs(size - earthGravity) / (0.2 * earthGravity));
    if (trust > 0) up_ = ((1 - share_ * trust) * up_ + share_ * trust * acc / size).normalized();
  }
  void reset(const Vec3& up = Vec3::UnitZ()) { up_ = up.normalized(); }

  /// The world's vertical in the torso frame, unit.
  const Vec3& up() const { return up_; }
  /// Turn about x that brings an upright torso to this one, after the pitch [rad].
  double roll() const { return std::atan2(up_.y(), up_.z()); }
  /// Turn about y, nose down positive [rad].
  double pitch() const { return std::atan2(-up_.x(), std::hypot(up_.y(), up_.z())); }

private:
  double share_;
  Vec3 up_ = Vec3::UnitZ();
};

}  // namespace plumbline
