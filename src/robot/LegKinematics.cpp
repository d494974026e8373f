#include "robot/LegKinematics.h"

#include <algorithm>

namespace plumbline {
namespace {

std::variant<ClosedFormLeg, IterativeLeg> legOf(const RobotModel& model, Side side) {
  if (ClosedFormLeg::fits(model, side)) {
    ClosedFormLeg leg(model, side);
    // A shared hip motor asks for solutions with a given hip yaw pitch.
    if (leg.ankleMeets() || !model.sharedHipYawPitch) return leg;
  }
  return IterativeLeg(model, side);
}

}  // namespace

LegKinematics::LegKinematics(const RobotModel& model, Side side) : leg_(legOf(model, side)) {
  const int first = firstLegJoint(side);
  const auto ankleRoll = static_cast<JointId>(first + 5), toePitch = static_cast<JointId>(first + 6);
  const Link& foot = model.linkMovedBy(ankleRoll);
  const Vec3 footHalf = foot.shape.size / 2;
  const Vec3 middle = foot.shape.T_link_shape.translation();
  double front = middle.x() + footHalf.x();
  const double back = middle.x() - footHalf.x();
  if (model.has(toePitch)) {
    const Link& toe = model.linkMovedBy(toePitch);
    front = std::max(front, toe.origin.x() + toe.com.x() + toe.shape.size.x() / 2);
  }
  T_foot_sole_ = translation((front + back) / 2, middle.y(), middle.z() - footHalf.z());
  soleHalfSize_ = Vec2((front - back) / 2, footHalf.y());
}

LegSolution LegKinematics::solve(const Pose3& T_torso_sole) const {
  const Pose3 T_torso_foot = T_torso_sole * T_foot_sole_.inverse();
  return std::visit([&](const auto& form) { return form.solve(T_torso_foot); }, leg_);
}

LegSolution LegKinematics::solve(const Pose3& T_torso_sole, double hipYawPitch) const {
  const Pose3 T_torso_foot = T_torso_sole * T_foot_sole_.inverse();
  return std::visit([&](const auto& form) { return form.solve(T_torso_foot, hipYawPitch); }, leg_);
}

Pose3 LegKinematics::sole(const LegAngles& angles) const {
  return std::visit([&](const auto& form) { return form.foot(angles); }, leg_) * T_foot_sole_;
}

const Vec3& LegKinematics::hip() const {
  return std::visit([](const auto& form) -> const Vec3& { return form.hip(); }, leg_);
}

double LegKinematics::ankleHeight() const {
  return std::visit([](const auto& form) { return form.ankleHeight(); }, leg_) -
         T_foot_sole_.translation().z();
}

double LegKinematics::maxReach() const {
  return std::visit([](const auto& form) { return form.maxReach(); }, leg_);
}

}  // namespace plumbline
