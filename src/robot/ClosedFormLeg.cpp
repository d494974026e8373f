#include "robot/ClosedFormLeg.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "math/Angle.h"

namespace plumbline {
namespace {

constexpr double exact = 1e-9;

/// Angle of a vector in the plane x-z, such that a rotation about y by a raises it by a.
double pitchOf(const Vec3& v) { return std::atan2(v.x(), v.z()); }

}  // namespace

bool ClosedFormLeg::fits(const RobotModel& model, Side side) {
  const JointId first = firstLegJoint(side);
  const double outside = side == Side::left ? 1 : -1;
  const Vec3 axes[6] = {Vec3(0, 1, -outside).normalized(),
                        Vec3::UnitX(),
                        Vec3::UnitY(),
                        Vec3::UnitY(),
                        Vec3::UnitY(),
                        Vec3::UnitX()};
  for (int i = 0; i < 6; ++i) {
    const JointId joint = static_cast<JointId>(first + i);
    if (!model.has(joint) || (model.linkMovedBy(joint).axis - axes[i]).norm() > exact ||
        model.linkMovedBy(joint).parent != (i > 0 ? model.linkOfJoint[joint - 1] : 0))
      return false;
  }
  const auto origin = [&](int i) -> const Vec3& {
    return model.linkMovedBy(static_cast<JointId>(first + i)).origin;
  };
  const bool hipMeets = origin(1).norm() < exact && origin(2).norm() < exact;
  const bool planar =
      std::abs(origin(3).y()) < exact && std::abs(origin(4).y()) < exact && std::abs(origin(5).y()) < exact;
  return hipMeets && planar;
}

ClosedFormLeg::ClosedFormLeg(const RobotModel& model, Side side) : side_(side) {
  const JointId first = firstLegJoint(side_);
  std::array<const Link*, 6> link{};
  for (std::size_t k = 0; k < 6; ++k) {
    link[k] = &model.linkMovedBy(static_cast<JointId>(first + static_cast<int>(k)));
    lower_[k] = link[k]->lower;
    upper_[k] = link[k]->upper;
  }
  hip_ = link[0]->origin;
  kneeOffset_ = link[3]->origin;
  ankleOffset_ = link[4]->origin;
  rollOffset_ = link[5]->origin;
  thighLength_ = kneeOffset_.norm();
  shankLength_ = ankleOffset_.norm();
  bendAtZero_ = pitchOf(-ankleOffset_) - pitchOf(-kneeOffset_);
  maxReach_ = reach(lower_[3]);
  minReach_ = reach(upper_[3]);
}

double ClosedFormLeg::reach(double knee) const {
  return std::sqrt(thighLength_ * thighLength_ + shankLength_ * shankLength_ +
                   2 * thighLength_ * shankLength_ * std::cos(knee + bendAtZero_));
}

LegSolution ClosedFormLeg::solve(const Pose3& T_torso_foot) const {
  LegSolution solution;
  LegAngles& q = solution.angles;

  // Ankle roll: turn the foot back until the hip lies in the leg's plane, which contains the roll axis. Of
  // the two such turns the one within 90 degrees, as the joint's limits are.
  const Vec3 hipInFoot = T_torso_foot.inverse() * hip_;
  q[5] = std::atan2(std::copysign(1.0, hipInFoot.z()) * hipInFoot.y(), std::abs(hipInFoot.z()));
  const Mat3 R_torso_ankle =
      T_torso_foot.linear() * Eigen::AngleAxisd(-q[5], Vec3::UnitX()).toRotationMatrix();
  // Hip seen from the ankle's pitch axis, in the ankle's frame: only x and z.
  const Vec3 ankleToHip = R_torso_ankle.transpose() * (hip_ - T_torso_foot.translation()) + rollOffset_;

  q[3] = kneeFor(ankleToHip.norm(), solution.reachable);

  // Ankle pitch: direction of the hip at this knee angle and ankle pitch 0, against the wanted one.
  const Mat3 R_knee = Eigen::AngleAxisd(-q[3], Vec3::UnitY()).toRotationMatrix();
  const Vec3 hipAtZero = -ankleOffset_ - R_knee * kneeOffset_;
  q[4] = pitchOf(hipAtZero) - pitchOf(ankleToHip);
  q[4] = std::remainder(q[4], 2 * pi);

  // Hip: the yaw-pitch axis becomes the vertical by a turn of 45 degrees about x, which leaves Euler angles z
  // x y.
  const Mat3 R_torso_thigh =
      R_torso_ankle * Eigen::AngleAxisd(-q[3] - q[4], Vec3::UnitY()).toRotationMatrix();
  const double outside = side_ == Side::left ? 1 : -1;
  const Mat3 m = Eigen::AngleAxisd(-outside * pi / 4, Vec3::UnitX()).toRotationMatrix() * R_torso_thigh;
  q[0] = -outside * std::atan2(-m(0, 1), m(1, 1));
  q[1] = std::asin(std::clamp(m(2, 1), -1.0, 1.0)) + outside * pi / 4;
  q[2] = std::atan2(-m(2, 0), m(2, 2));

  clip(solution);
  return solution;
}

bool ClosedFormLeg::ankleMeets() const { return rollOffset_.norm() < exact; }

LegSolution ClosedFormLeg::solve(const Pose3& T_torso_foot, double hipYawPitch) const {
  if (!ankleMeets())
    throw std::logic_error("a leg whose ankle axes do not meet has no solution for a given hip yaw pitch");
  LegSolution solution;
  LegAngles& q = solution.angles;
  const double outside = side_ == Side::left ? 1 : -1;
  const Mat3 R_torso_pelvis =
      Eigen::AngleAxisd(hipYawPitch, Vec3(0, 1, -outside).normalized()).toRotationMatrix();
  const Vec3 ankle = R_torso_pelvis.transpose() * (T_torso_foot.translation() - hip_);
  q[0] = hipYawPitch;
  q[1] = std::atan2(ankle.y(), -ankle.z());
  q[3] = kneeFor(ankle.norm(), solution.reachable);
  // Direction of the ankle in the leg's plane against that at hip pitch 0.
  const Vec3 inPlane = rotationX(-q[1]).linear() * ankle;
  const Vec3 atZero = kneeOffset_ + rotationY(q[3]).linear() * ankleOffset_;
  q[2] = std::remainder(pitchOf(-inPlane) - pitchOf(-atZero), 2 * pi);
  const Mat3 R_torso_shank = R_torso_pelvis * (rotationX(q[1]) * rotationY(q[2] + q[3])).linear();
  const Vec3 up = R_torso_shank.transpose() * T_torso_foot.linear().col(2);
  q[4] = std::atan2(up.x(), up.z());
  q[5] = -std::asin(std::clamp(up.y(), -1.0, 1.0));
  clip(solution);
  return solution;
}

double ClosedFormLeg::kneeFor(double wanted, bool& reachable) const {
  const double distance = std::clamp(wanted, minReach_, maxReach_);
  reachable = std::abs(distance - wanted) < exact;
  const double cosBend = (distance * distance - thighLength_ * thighLength_ - shankLength_ * shankLength_) /
                         (2 * thighLength_ * shankLength_);
  return std::acos(std::clamp(cosBend, -1.0, 1.0)) - bendAtZero_;
}

void ClosedFormLeg::clip(LegSolution& solution) const {
  for (std::size_t i = 0; i < 6; ++i) {
    double& q = solution.angles[i];
    const double clipped = std::clamp(q, lower_[i], upper_[i]);
    if (std::abs(clipped - q) > exact) solution.reachable = false;
    q = clipped;
  }
}

Pose3 ClosedFormLeg::foot(const LegAngles& q) const {
  const double outside = side_ == Side::left ? 1 : -1;
  return translation(hip_) * rotation(Vec3(0, 1, -outside).normalized(), q[0]) * rotationX(q[1]) *
         rotationY(q[2]) * translation(kneeOffset_) * rotationY(q[3]) * translation(ankleOffset_) *
         rotationY(q[4]) * translation(rollOffset_) * rotationX(q[5]);
}

}  // namespace plumbline
