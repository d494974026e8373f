#pragma once
#include "math/Types.h"

namespace plumbline {

/// A convex primitive in a link's frame. box: size = full edge lengths; sphere: size.x = radius;
/// capsule (axis z): size.x = radius, size.z = length of the cylinder part [m].
struct Shape {
  enum class Kind { box, sphere, capsule };
  Kind kind = Kind::box;
  Vec3 size = Vec3::Zero();
  Pose3 T_link_shape = Pose3::Identity();
};

}  // namespace plumbline
