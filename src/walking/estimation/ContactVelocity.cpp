#include "walking/estimation/ContactVelocity.h"

#include <algorithm>

#include "walking/model/WalkState.h"

namespace plumbline::walking {

ContactVelocity::ContactVelocity(const RobotModel& robot) : mass_(robot.totalMass()) {
  for (const Side side : {Side::left, Side::right}) {
    const int ankle = firstLegJoint(side) + 5;
    parts_[index(side)].link = robot.linkOfJoint[static_cast<std::size_t>(ankle)];
    parts_[2 + index(side)].link = robot.linkOfJoint[static_cast<std::size_t>(ankle + 1)];
  }
  for (Part& part : parts_)
    if (part.link >= 0) part.centre = robot.links[static_cast<std::size_t>(part.link)].com;
}

VelocityEvidence ContactVelocity::update(const ForwardKinematics& kinematics, const Mat3& upright,
                                         double turn, const FootSensors& feet, double dt) {
  const Eigen::Rotation2Dd turned(-turn);
  Vec3 force = Vec3::Zero();
  Vec2 moved = Vec2::Zero();
  double load = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    if (part.link < 0) continue;
    const Pose3 before = part.pose;
    const Pose3& link = kinematics.link(part.link);
    part.pose.linear() = upright * link.linear();
    part.pose.translation() = upright * (link.translation() - kinematics.com());
    const std::optional<FootContact>& contact = i < 2 ? feet.foot[i] : feet.toe[i - 2];
    if (!contact) continue;
    const Vec3 pressed = part.pose.linear() * contact->force;
    force += pressed;
    const double weight = std::max(0.0, pressed.z());
    const Vec3 point = contact->point + part.centre;
    moved += weight * (turned * (before * point).head<2>() - (part.pose * point).head<2>());
    load += weight;
  }
  VelocityEvidence evidence;
  if (feet.shear) evidence.change = force.head<2>() * (dt / mass_);
  if (begun_ && load > 0) evidence.seen = moved / (load * dt);
  begun_ = true;
  return evidence;
}

}  // namespace plumbline::walking
