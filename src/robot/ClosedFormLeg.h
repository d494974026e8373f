#pragma once
#include "math/Types.h"
#include "robot/LegSolution.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// Analytic inverse kinematics of a leg as in SimSpark's robots and the NAO. Its three hip axes (yaw pitch at
/// 45 degrees, roll, pitch) meet in one point, and hip pitch, knee and ankle pitch move in one plane. The
/// ankle's roll axis may lie below its pitch axis; the solution is exact all the same. Of a pose out of reach
/// the distance of hip and ankle is clipped along their line, then each joint to its limits. Poses are the
/// foot's: of the link that the ankle's roll moves, in the torso frame [m].
class ClosedFormLeg {
public:
  /// Whether this leg of the model is such a leg.
  static bool fits(const RobotModel& model, Side side);
  /// For a leg that fits.
  ClosedFormLeg(const RobotModel& model, Side side);

  LegSolution solve(const Pose3& T_torso_foot) const;
  /// The same with the hip yaw pitch given [rad]: place and tilt of the foot are as requested, its heading
  /// follows from the hip. Throws std::logic_error unless ankleMeets().
  LegSolution solve(const Pose3& T_torso_foot, double hipYawPitch) const;
  /// Whether the ankle's two axes meet.
  bool ankleMeets() const;

  Pose3 foot(const LegAngles& angles) const;
  /// Meeting point of the hip axes in the torso frame [m].
  const Vec3& hip() const { return hip_; }
  /// Height of the ankle's pitch axis over the foot's frame when the foot is level [m].
  double ankleHeight() const { return -rollOffset_.z(); }
  /// Largest distance of the hip from the axis of the ankle's pitch within the knee's limits [m].
  double maxReach() const { return maxReach_; }

private:
  double reach(double knee) const;
  double kneeFor(double wanted, bool& reachable) const;
  void clip(LegSolution& solution) const;

  Side side_;
  Vec3 hip_, kneeOffset_, ankleOffset_,
      rollOffset_;                       ///< origins of thigh, shank, ankle, foot in their parents [m]
  std::array<double, 6> lower_, upper_;  ///< [rad]
  double thighLength_, shankLength_,
      bendAtZero_;  ///< bendAtZero: angle between thigh and shank at knee 0 [rad]
  double maxReach_, minReach_;
};

}  // namespace plumbline
