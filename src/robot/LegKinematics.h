#pragma once
#include <variant>

#include "robot/ClosedFormLeg.h"
#include "robot/IterativeLeg.h"

namespace plumbline {

/// Forward and inverse kinematics of a leg down to its sole: in closed form if the leg's geometry allows it
/// (ClosedFormLeg), else by iteration (IterativeLeg). The robot's geometry decides when the model is loaded.
class LegKinematics {
public:
  /// Throws std::invalid_argument for a leg with fewer than six joints.
  LegKinematics(const RobotModel& model, Side side);

  /// Joint angles that bring the sole to the pose T_torso_sole.
  LegSolution solve(const Pose3& T_torso_sole) const;
  /// The same for a given hip yaw pitch [rad] (a robot whose legs share that motor). The ankle is at its
  /// place in the pose and the sole is in the pose's plane; the heading follows from the hip. Throws
  /// std::logic_error for a leg in closed form whose ankle axes do not meet, unless its robot shares the
  /// motor.
  LegSolution solve(const Pose3& T_torso_sole, double hipYawPitch) const;
  /// Sole of the leg with these angles, by the leg's own short chain.
  Pose3 sole(const LegAngles& angles) const;

  /// Sole frame in the foot's link: centre of the lower face of foot (and toe), axes of the foot.
  const Pose3& T_foot_sole() const { return T_foot_sole_; }
  /// Half lengths of the sole, forward and left [m].
  const Vec2& soleHalfSize() const { return soleHalfSize_; }
  /// Meeting point of the hip axes in the torso frame, or the point nearest to them [m].
  const Vec3& hip() const;
  /// Height of the ankle's pitch axis over the flat sole [m].
  double ankleHeight() const;
  /// Largest distance of the hip from the axis of the ankle's pitch within the knee's limits [m].
  double maxReach() const;
  bool closedForm() const { return std::holds_alternative<ClosedFormLeg>(leg_); }

private:
  std::variant<ClosedFormLeg, IterativeLeg> leg_;
  Pose3 T_foot_sole_ = Pose3::Identity();
  Vec2 soleHalfSize_;
};

}  // namespace plumbline
