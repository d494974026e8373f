#pragma once
#include "math/Types.h"

namespace plumbline::simulation {

/// A body in the world: pose and velocities of its frame's origin, world coordinates [m, m/s, rad/s].
struct BodyState {
  Pose3 pose = Pose3::Identity();
  Vec3 linearVelocity = Vec3::Zero();
  Vec3 angularVelocity = Vec3::Zero();
};

}  // namespace plumbline::simulation
