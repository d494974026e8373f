#pragma once
#include <optional>

#include "robot/LegChain.h"

namespace plumbline {

/// Inverse kinematics of any leg of six joints, for hips whose axes do not meet. Uses Gauss-Newton steps on
/// the foot's pose, damped by the square of the error, within the joints' limits (Sugihara,
/// Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method, IEEE T-RO 27(5), 2011). It
/// begins from the same postures every time, so the same pose gives the same angles. Allocates nothing. Poses
/// are the foot's: of the link that the ankle's roll moves, in the torso frame [m].
class IterativeLeg {
public:
  /// Throws std::invalid_argument as LegChain does.
  IterativeLeg(const RobotModel& model, Side side);

  LegSolution solve(const Pose3& T_torso_foot) const;
  /// The same with the hip yaw pitch given [rad]: place and tilt of the foot are as requested, its heading
  /// follows from the hip.
  LegSolution solve(const Pose3& T_torso_foot, double hipYawPitch) const;

  Pose3 foot(const LegAngles& angles) const { return chain_.poses(angles).back(); }
  /// The point nearest to the three hip axes with all joints at zero, torso frame [m].
  const Vec3& hip() const { return hip_; }
  /// Height of the ankle's pitch axis over the foot's frame when all joints are at zero [m].
  double ankleHeight() const { return ankleHeight_; }
  /// Largest distance of the hip from the axis of the ankle's pitch within the knee's limits, the others at
  /// zero [m].
  double maxReach() const { return maxReach_; }

private:
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  struct Target {
    Pose3 foot;
    std::optional<double> hipYawPitch;
  };

  LegSolution solve(const Target& target) const;
  Vec6 errorOf(const Target& target, const std::array<Pose3, 6>& poses) const;
  Mat6 jacobian(const Target& target, const std::array<Pose3, 6>& poses) const;
  double descend(const Target& target, LegAngles& angles) const;

  LegChain chain_;
  Vec3 hip_ = Vec3::Zero();
  double ankleHeight_ = 0, maxReach_ = 0;
};

}  // namespace plumbline
