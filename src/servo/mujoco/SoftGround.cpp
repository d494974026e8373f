#include "servo/mujoco/SoftGround.h"

#include <algorithm>
#include <cmath>

namespace plumbline::servo::mujoco {

SoftGround::SoftGround(const Mechanism& robot, double compliance, double friction, const Mat3& slope)
    : stiffness_(1 / std::max(compliance, 5e-6)), friction_(friction), up_(slope.col(2)) {
  const double mass = robot.totalMass() / 8;
  damping_ = 1.4 * std::sqrt(stiffness_ * mass);
  sideStiffness_ = 5e4;
  sideDamping_ = 1.4 * std::sqrt(sideStiffness_ * mass);
  for (std::size_t f = 0; f < robot.feet.size(); ++f) {
    const Mechanism::Foot& foot = robot.feet[f];
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) {
        Corner corner;
        corner.foot = static_cast<int>(f);
        corner.link = foot.link;
        corner.local =
            foot.soleCentre + Vec3(x * foot.soleSize.x(), y * foot.soleSize.y(), -0.5 * foot.soleSize.z());
        list_.push_back(corner);
      }
  }
}

void SoftGround::update(Corner& corner, const Vec3& place, const Vec3& speed) {
  const double depth = -up_.dot(place), sinking = -up_.dot(speed);
  corner.force.setZero();
  corner.normal = depth > 0 ? std::max(0.0, stiffness_ * depth + damping_ * sinking) : 0;
  if (depth <= 0) {
    corner.touches = false;
    return;
  }
  if (!corner.touches) corner.anchor = place;
  corner.touches = true;
  Vec3 off = place - corner.anchor;
  off -= up_ * up_.dot(off);
  const Vec3 sliding = speed - up_ * up_.dot(speed);
  Vec3 side = -sideStiffness_ * off - sideDamping_ * sliding;
  const double most = friction_ * corner.normal;
  if (side.norm() > most) {
    side *= most / side.norm();
    // The anchor is dragged along.
    corner.anchor = place + side / sideStiffness_;
  }
  corner.force = side + corner.normal * up_;
}

}  // namespace plumbline::servo::mujoco
