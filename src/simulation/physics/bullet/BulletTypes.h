#pragma once
// Before anything of Bullet: its double-precision build has classes of another size.
#ifndef BT_USE_DOUBLE_PRECISION
#define BT_USE_DOUBLE_PRECISION
#endif
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletCollisionCommon.h>

#include <limits>

#include "math/Types.h"

namespace plumbline::simulation::bullet {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline Vec3 toVec3(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline btVector3 fromVec3(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

inline btQuaternion fromMat3(const Mat3& m) {
  const Eigen::Quaterniond q(m);
  return {q.x(), q.y(), q.z(), q.w()};
}

inline Pose3 toPose3(const btTransform& t) {
  Pose3 pose = Pose3::Identity();
  const btMatrix3x3& m = t.getBasis();
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 3; ++col) pose.linear()(row, col) = m[row][col];
  pose.translation() = toVec3(t.getOrigin());
  return pose;
}
inline btTransform fromPose3(const Pose3& pose) {
  const Mat3 m = pose.linear();
  return btTransform(
      btMatrix3x3(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)),
      fromVec3(pose.translation()));
}

}  // namespace plumbline::simulation::bullet
