#pragma once
#include <array>

#include "robot/RobotModel.h"

namespace plumbline {

/// Angles of one leg from hip yaw pitch to ankle roll [rad], in the order of JointId; the toe is not moved.
using LegAngles = std::array<double, 6>;

struct LegSolution {
  LegAngles angles{};
  /// False if the pose cannot be reached; angles then reach the nearest pose found: the distance of hip and
  /// ankle is clipped along their line, then each joint to its limits.
  bool reachable = true;
};

/// Analytic inverse kinematics of a leg whose three hip axes (yaw pitch at 45 degrees, roll, pitch) meet in
/// one point and whose hip pitch, knee and ankle pitch move in one plane, as in SimSpark's robots and the
/// NAO. The ankle's roll axis may lie below its pitch axis; the solution is exact all the same.
class LegKinematics {
public:
  /// Throws std::invalid_argument if the model's leg has another structure.
  LegKinematics(const RobotModel& model, Side side);

  /// Joint angles that bring the sole to the pose T_torso_sole.
  LegSolution solve(const Pose3& T_torso_sole) const;

  /// The same with the hip yaw pitch given (a robot whose legs share that motor): the ankle comes where the
  /// pose has it and the sole lies in its plane; its heading is what the hip makes of it. Throws
  /// std::logic_error for a leg whose ankle axes do not meet.
  LegSolution solve(const Pose3& T_torso_sole, double hipYawPitch) const;

  /// Sole of the leg with these angles, by the leg's own short chain.
  Pose3 sole(const LegAngles& angles) const;

  /// Sole frame in the foot's link: centre of the lower face of foot (and toe), axes of the foot.
  const Pose3& T_foot_sole() const { return T_foot_sole_; }
  /// Half lengths of the sole, forward and left [m].
  const Vec2& soleHalfSize() const { return soleHalfSize_; }
  /// Meeting point of the hip axes in the torso frame [m].
  const Vec3& hip() const { return hip_; }
  /// Height of the ankle's pitch axis over the flat sole [m].
  double ankleHeight() const { return -rollOffset.z() - T_foot_sole_.translation().z(); }
  /// Largest distance of the hip from the axis of the ankle's pitch within the knee's limits [m].
  double maxReach() const { return maxReach_; }

private:
  double reach(double knee) const;
  double kneeFor(double wanted, bool& reachable) const;
  void clip(LegSolution& solution) const;

  Side side;
  Vec3 hip_, kneeOffset, ankleOffset,
      rollOffset;                               ///< origins of thigh, shank, ankle, foot in their parents [m]
  std::array<double, 6> lower, upper;           ///< [rad]
  double thighLength, shankLength, bendAtZero;  ///< bendAtZero: angle between thigh and shank at knee 0 [rad]
  double maxReach_, minReach_;
  Pose3 T_foot_sole_ = Pose3::Identity();
  Vec2 soleHalfSize_;
};

}  // namespace plumbline
