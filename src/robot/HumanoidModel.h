#pragma once
#include <array>
#include <vector>

#include "robot/Mechanism.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// The model of a mechanism for kinematics and walk: joints get their numbers (OwnJoints.h) instead of names.
/// Sliding joints, and joints without a humanoid's name that follow another joint's motor (fingers), are
/// fixed at zero; the mass of their link belongs to the link that carries it. A foot's link without a shape
/// of its own has the sole's box; a leg driven at the hip by the other leg's motor makes
/// RobotModel::sharedHipYawPitch true.
class Humanoid {
public:
  /// Throws std::invalid_argument for a mechanism that the model cannot describe: a joint frame rotated in
  /// its parent, a foot of a humanoid that no ankle moves, too many joints of its own.
  explicit Humanoid(const Mechanism& mechanism);

  const RobotModel& model() const { return model_; }

  /// Index of a joint in the mechanism, -1 if the robot does not have it.
  int mechanismJoint(JointId joint) const { return indices_[static_cast<std::size_t>(joint)]; }
  /// One value per joint of the mechanism as the model's, 0 where there is none, and back (joints without a
  /// number: 0).
  JointArray toModel(const std::vector<double>& values) const;
  std::vector<double> toMechanism(const JointArray& values) const;

private:
  RobotModel model_;
  PerJoint<int> indices_{};
  std::size_t mechanismJoints_;
};

/// The robot's left and right foot in Mechanism::feet, by its ankles. Throws std::invalid_argument for a
/// robot with other than two feet.
std::array<std::size_t, 2> twoFeet(const Mechanism& mechanism, const Humanoid& humanoid);

}  // namespace plumbline
