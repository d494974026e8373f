#pragma once
#include <cmath>

#include "math/Pose2.h"
#include "math/Types.h"

namespace plumbline {

/// The ground frame of a torso on the field: below the torso's centre, x where the torso's x points.
inline Pose2 groundPose(const Pose3& T_field_torso) {
  const Vec3 forward = T_field_torso.linear().col(0);
  return Pose2(Vec2(T_field_torso.translation().head<2>()), std::atan2(forward.y(), forward.x()));
}

}  // namespace plumbline
