#pragma once
#include <array>
#include <vector>

#include "robot/Mechanism.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// A mechanism with the names of a humanoid's joints (JointId) as the model that kinematics and walk know:
/// names instead of indices stop here. Joints without such a name (wrists, fingers) are taken as fixed at
/// zero, their links' masses belong to the link that carries them. A foot's link without a shape of its own
/// has the sole's box; a leg driven at the hip by the other leg's motor makes RobotModel::sharedHipYawPitch
/// true.
class Humanoid {
public:
  /// Throws std::invalid_argument for a mechanism whose axes the model cannot say: a joint frame turned in
  /// its parent, or a foot that is not moved by an ankle.
  explicit Humanoid(const Mechanism& mechanism);

  const RobotModel& model() const { return model_; }

  /// Index of a joint in the mechanism, -1 where the robot lacks it.
  int mechanismJoint(JointId joint) const { return indices[static_cast<std::size_t>(joint)]; }
  /// One value per joint of the mechanism as the model's, 0 where there is none, and back (joints without a
  /// JointId: 0).
  JointArray toModel(const std::vector<double>& values) const;
  std::vector<double> toMechanism(const JointArray& values) const;

private:
  RobotModel model_;
  std::array<int, numJoints> indices{};
  std::size_t mechanismJoints;
};

}  // namespace plumbline
