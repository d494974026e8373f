#include "robot/LegKinematics.h"

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

LegKinematics::LegKinematics(const RobotModel& model, Side side_) : side(side_) {
  const JointId first = firstLegJoint(side);
  const double outside = side == Side::left ? 1 : -1;
  const Vec3 axes[6] = {Vec3(0, 1, -outside).normalized(),
                        Vec3::UnitX(),
                        Vec3::UnitY(),
                        Vec3::UnitY(),
                        Vec3::UnitY(),
                        Vec3::UnitX()};
  std::array<const Link*, 6> link{};
  for (int i = 0; i < 6; ++i) {
    const JointId joint = static_cast<JointId>(first + i);
    if (!model.has(joint) || (model.linkMovedBy(joint).axis - axes[i]).norm() > exact ||
        (i > 0 && model.linkMovedBy(joint).parent != model.linkOfJoint[joint - 1]))
      throw std::invalid_argument("robot " + model.name + " has no leg joint " +
                                  std::string(jointNames[joint]) + " as this leg kinematics needs it");
    const auto k = static_cast<std::size_t>(i);
    link[k] = &model.linkMovedBy(joint);
    lower[k] = link[k]->lower;
    upper[k] = link[k]->upper;
  }
  hip_ = link[0]->origin;
  kneeOffset = link[3]->origin;
  ankleOffset = link[4]->origin;
  rollOffset = link[5]->origin;
  const bool hipMeets = link[1]->origin.norm() < exact && link[2]->origin.norm() < exact;
  const bool planar = std::abs(kneeOffset.y()) < exact && std::abs(ankleOffset.y()) < exact &&
                      std::abs(rollOffset.y()) < exact;
  if (!hipMeets || !planar || model.links[0].name != "torso" || link[0]->parent != 0)
    throw std::invalid_argument("robot " + model.name + " has leg offsets this leg kinematics cannot solve");

  thighLength = kneeOffset.norm();
  shankLength = ankleOffset.norm();
  bendAtZero = pitchOf(-ankleOffset) - pitchOf(-kneeOffset);
  maxReach_ = reach(lower[3]);
  minReach_ = reach(upper[3]);

  const Link& foot = *link[5];
  const Vec3 footHalf = foot.shape.size / 2;
  const Vec3 middle = foot.shape.T_link_shape.translation();
  double front = middle.x() + footHalf.x();
  const double back = middle.x() - footHalf.x();
  if (model.has(static_cast<JointId>(first + 6))) {
    const Link& toe = model.linkMovedBy(static_cast<JointId>(first + 6));
    front = std::max(front, toe.origin.x() + toe.com.x() + toe.shape.size.x() / 2);
  }
  T_foot_sole_ = translation((front + back) / 2, middle.y(), middle.z() - footHalf.z());
  soleHalfSize_ = Vec2((front - back) / 2, footHalf.y());
}

double LegKinematics::reach(double knee) const {
  return std::sqrt(thighLength * thighLength + shankLength * shankLength +
                   2 * thighLength * shankLength * std::cos(knee + bendAtZero));
}

LegSolution LegKinematics::solve(const Pose3& T_torso_sole) const {
  LegSolution solution;
  LegAngles& q = solution.angles;
  const Pose3 T_torso_foot = T_torso_sole * T_foot_sole_.inverse();

  // Ankle roll: turn the foot back until the hip lies in the leg's plane, which contains the roll axis. Of
  // the two such turns the one within 90 degrees, as the joint's limits are.
  const Vec3 hipInFoot = T_torso_foot.inverse() * hip_;
  q[5] = std::atan2(std::copysign(1.0, hipInFoot.z()) * hipInFoot.y(), std::abs(hipInFoot.z()));
  const Mat3 R_torso_ankle =
      T_torso_foot.linear() * Eigen::AngleAxisd(-q[5], Vec3::UnitX()).toRotationMatrix();
  // Hip seen from the ankle's pitch axis, in the ankle's frame: only x and z.
  const Vec3 ankleToHip = R_torso_ankle.transpose() * (hip_ - T_torso_foot.translation()) + rollOffset;

  q[3] = kneeFor(ankleToHip.norm(), solution.reachable);

  // Ankle pitch: direction of the hip at this knee angle and ankle pitch 0, against the wanted one.
  const Mat3 R_knee = Eigen::AngleAxisd(-q[3], Vec3::UnitY()).toRotationMatrix();
  const Vec3 hipAtZero = -ankleOffset - R_knee * kneeOffset;
  q[4] = pitchOf(hipAtZero) - pitchOf(ankleToHip);
  q[4] = std::remainder(q[4], 2 * pi);

  // Hip: the yaw-pitch axis becomes the vertical by a turn of 45 degrees about x, which leaves Euler angles z
  // x y.
  const Mat3 R_torso_thigh =
      R_torso_ankle * Eigen::AngleAxisd(-q[3] - q[4], Vec3::UnitY()).toRotationMatrix();
  const double outside = side == Side::left ? 1 : -1;
  const Mat3 m = Eigen::AngleAxisd(-outside * pi / 4, Vec3::UnitX()).toRotationMatrix() * R_torso_thigh;
  q[0] = -outside * std::atan2(-m(0, 1), m(1, 1));
  q[1] = std::asin(std::clamp(m(2, 1), -1.0, 1.0)) + outside * pi / 4;
  q[2] = std::atan2(-m(2, 0), m(2, 2));

  clip(solution);
  return solution;
}

LegSolution LegKinematics::solve(const Pose3& T_torso_sole, double hipYawPitch) const {
  if (rollOffset.norm() > exact)
    throw std::logic_error("a leg whose ankle axes do not meet has no solution for a given hip yaw pitch");
  LegSolution solution;
  LegAngles& q = solution.angles;
  const double outside = side == Side::left ? 1 : -1;
  const Pose3 T_torso_foot = T_torso_sole * T_foot_sole_.inverse();
  const Mat3 R_torso_pelvis =
      Eigen::AngleAxisd(hipYawPitch, Vec3(0, 1, -outside).normalized()).toRotationMatrix();
  const Vec3 ankle = R_torso_pelvis.transpose() * (T_torso_foot.translation() - hip_);
  q[0] = hipYawPitch;
  q[1] = std::atan2(ankle.y(), -ankle.z());
  q[3] = kneeFor(ankle.norm(), solution.reachable);
  // Direction of the ankle in the leg's plane against that at hip pitch 0.
  const Vec3 inPlane = rotationX(-q[1]).linear() * ankle;
  const Vec3 atZero = kneeOffset + rotationY(q[3]).linear() * ankleOffset;
  q[2] = std::remainder(pitchOf(-inPlane) - pitchOf(-atZero), 2 * pi);
  const Mat3 R_torso_shank = R_torso_pelvis * (rotationX(q[1]) * rotationY(q[2] + q[3])).linear();
  const Vec3 up = R_torso_shank.transpose() * T_torso_foot.linear().col(2);
  q[4] = std::atan2(up.x(), up.z());
  q[5] = -std::asin(std::clamp(up.y(), -1.0, 1.0));
  clip(solution);
  return solution;
}

double LegKinematics::kneeFor(double wanted, bool& reachable) const {
  const double distance = std::clamp(wanted, minReach_, maxReach_);
  reachable = std::abs(distance - wanted) < exact;
  const double cosBend = (distance * distance - thighLength * thighLength - shankLength * shankLength) /
                         (2 * thighLength * shankLength);
  return std::acos(std::clamp(cosBend, -1.0, 1.0)) - bendAtZero;
}

void LegKinematics::clip(LegSolution& solution) const {
  for (std::size_t i = 0; i < 6; ++i) {
    double& q = solution.angles[i];
    const double clipped = std::clamp(q, lower[i], upper[i]);
    if (std::abs(clipped - q) > exact) solution.reachable = false;
    q = clipped;
  }
}

Pose3 LegKinematics::sole(const LegAngles& q) const {
  const double outside = side == Side::left ? 1 : -1;
  return translation(hip_) * rotation(Vec3(0, 1, -outside).normalized(), q[0]) * rotationX(q[1]) *
         rotationY(q[2]) * translation(kneeOffset) * rotationY(q[3]) * translation(ankleOffset) *
         rotationY(q[4]) * translation(rollOffset) * rotationX(q[5]) * T_foot_sole_;
}

}  // namespace plumbline
