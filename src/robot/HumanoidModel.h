#pragma once
#include <vector>

#include "robot/Mechanism.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// A mechanism as the model that kinematics and walk know: its joints get their numbers (OwnJoints.h), names
/// instead of indices stop here. What slides or follows another joint's motor without a humanoid's name
/// (fingers) is taken as fixed at zero; its link's mass belongs to the link that carries it. A foot's link
/// without a shape of its own has the sole's box; a leg driven at the hip by the other leg's motor makes
/// RobotModel::sharedHipYawPitch true.
class Humanoid {
public:
  /// Throws std::invalid_argument for a mechanism whose axes the model cannot say: a joint frame turned in
  /// its parent, a humanoid's foot that is not moved by an ankle, more joints of its own than there is room
  /// for.
  explicit Humanoid(const Mechanism& mechanism);

  const RobotModel& model() const { return model_; }

  /// Index of a joint in the mechanism, -1 where the robot lacks it.
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

}  // namespace plumbline
