#pragma once
#include <array>

#include "robot/RobotModel.h"

namespace plumbline {

/// Where the links of a robot are for given joint angles. Holds a reference to the model, which must outlive
/// it and stay as it is; update() allocates nothing. Throws std::invalid_argument for a model of more than
/// maxLinks links.
class ForwardKinematics {
public:
  static constexpr std::size_t maxLinks = 32;

  explicit ForwardKinematics(const RobotModel& model);

  /// Everything for these joint angles [rad]; joints the robot lacks are ignored. Links that are where they
  /// were last time are not worked out again.
  void update(const JointArray& angles);

  /// Pose of a link's frame (on its joint) in the torso frame.
  const Pose3& link(int index) const { return T_torso_link_[static_cast<std::size_t>(index)]; }
  /// Centre of mass of the whole robot in the torso frame [m].
  const Vec3& com() const { return com_; }
  const RobotModel& model() const { return model_; }

private:
  const RobotModel& model_;
  double totalMass_;
  std::array<Pose3, maxLinks> T_torso_link_;
  std::array<Vec3, maxLinks> moments_;  ///< of mass, about the torso's origin [kg m]
  JointArray angles_{};                 ///< of T_torso_link_
  bool known_ = false;                  ///< T_torso_link_ is of angles_
  Vec3 com_ = Vec3::Zero();
};

}  // namespace plumbline
