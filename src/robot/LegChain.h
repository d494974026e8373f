#pragma once
#include <array>

#include "math/Types.h"
#include "robot/LegSolution.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// The six joints of a leg from the torso to the foot, with whatever axes and in whatever order a robot has
/// them. Own joints of the robot between them (a waist) are at zero. Poses are in the torso frame [m].
class LegChain {
public:
  struct Joint {
    std::size_t angle = 0;       ///< which of LegAngles
    Vec3 origin = Vec3::Zero();  ///< in the frame of the joint before, the first in the torso's [m]
    Vec3 axis = Vec3::UnitZ();
    double lower = 0, upper = 0;  ///< [rad]
  };

  /// Throws std::invalid_argument for a leg with fewer joints; the text names the first that is missing.
  LegChain(const RobotModel& model, Side side);

  const std::array<Joint, 6>& joints() const { return joints_; }
  /// The link behind each joint, in the order of joints(); the last is the foot.
  std::array<Pose3, 6> poses(const LegAngles& angles) const;
  /// Each angle within its joint's limits; whether one had to be moved by more than rounding goes to `moved`.
  void clip(LegAngles& angles, bool& moved) const;

private:
  std::array<Joint, 6> joints_;
};

}  // namespace plumbline
