#include "robot/ForwardKinematics.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace plumbline {
namespace {

/// Rodrigues' formula for a unit axis.
Mat3 rotationAbout(const Vec3& u, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), d = 1 - c;
  const double x = u.x(), y = u.y(), z = u.z();
  Mat3 r;
  r << c + d * x * x, d * x * y - s * z, d * x * z + s * y,  //
      d * x * y + s * z, c + d * y * y, d * y * z - s * x,   //
      d * x * z - s * y, d * y * z + s * x, c + d * z * z;
  return r;
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

ForwardKinematics::ForwardKinematics(const RobotModel& model) : model_(model), totalMass_(model.totalMass()) {
  if (model.links.size() > maxLinks)
    throw std::invalid_argument("robot " + model.name + " has " + std::to_string(model.links.size()) +
                                " links, at most " + std::to_string(maxLinks) + " are possible");
  T_torso_link_.fill(Pose3::Identity());
  update(JointArray{});
}

void ForwardKinematics::update(const JointArray& angles) {
  Vec3 moment = Vec3::Zero();
  std::array<bool, maxLinks> moved;
  for (std::size_t i = 0; i < model_.links.size(); ++i) {
    const Link& link = model_.links[i];
    Pose3& pose = T_torso_link_[i];
    moved[i] = !known_;
    if (link.parent >= 0) {
      const auto above = static_cast<std::size_t>(link.parent);
      moved[i] = moved[above] || !known_ || !sameBits(angles[link.joint], angles_[link.joint]);
      const Pose3& parent = T_torso_link_[above];
      if (moved[i]) {
        pose.translation().noalias() = parent.linear() * link.origin + parent.translation();
        pose.linear().noalias() = parent.linear() * rotationAbout(link.axis, angles[link.joint]);
      }
    }
    if (moved[i]) moments_[i] = link.mass * (pose.linear() * link.com + pose.translation());
    moment += moments_[i];
  }
  angles_ = angles;
  known_ = true;
  com_ = moment / totalMass_;
}

}  // namespace plumbline
