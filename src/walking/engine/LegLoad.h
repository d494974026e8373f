#pragma once
#include "robot/ForwardKinematics.h"
#include "robot/LegKinematics.h"

namespace plumbline::walking {

/// Load of the legs' servos: the torques [N m] with which the joints carry the robot's weight when the
/// ground's forces act on the soles. The force points from each sole's point of pressure to the centre of
/// mass, as in the pendulum, so the mass may be off the foot and accelerate.
class LegLoad {
public:
  explicit LegLoad(const RobotModel& robot);
  LegLoad(const LegLoad&) = delete;
  LegLoad& operator=(const LegLoad&) = delete;

  /// Torques of the leg joints for joint angles, the torso's lean (roll, pitch [rad]) and the share of the
  /// weight on the left and right sole (sum 1). pressure: from the sole's centre, forward and to the outside
  /// [m]. Other joints: those that hold the arms and the head against gravity.
  const JointArray& update(const JointArray& angles, const Vec2& torsoAngles,
                           const std::array<double, 2>& share, const Vec2& pressure);

private:
  RobotModel robot_;
  ForwardKinematics kinematics_;
  std::array<LegKinematics, 2> legs_;
  double mass_;
  JointArray torque_{};
};

}  // namespace plumbline::walking
