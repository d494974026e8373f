#pragma once
#include <Eigen/Geometry>
#include <array>
#include <string_view>

#include "math/Types.h"

namespace plumbline::gap {

/// Channels of the torso's true pose in the world, in order: position [m], then rotation.
constexpr std::array<std::string_view, 7> poseAxes{"x", "y", "z", "qw", "qx", "qy", "qz"};

/// Their values; the quaternion has qw >= 0.
inline std::array<double, 7> poseValues(const Pose3& T_world_torso) {
  const Vec3 p = T_world_torso.translation();
  Eigen::Quaterniond q(T_world_torso.linear());
  if (q.w() < 0) q.coeffs() *= -1;
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
}

}  // namespace plumbline::gap
