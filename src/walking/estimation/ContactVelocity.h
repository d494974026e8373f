#pragma once
#include "robot/ForwardKinematics.h"
#include "walking/estimation/VelocityFilter.h"
#include "walking/estimation/WalkSensors.h"

namespace plumbline::walking {

/// Velocity from the ground's effect on the feet: its forces give the acceleration of the centre of mass, and
/// at the points of contact the foot does not move. This also holds for a foot that rolls over its edge or is
/// not the planned support foot. The movement of the commanded foot's centre cannot show that.
class ContactVelocity {
public:
  explicit ContactVelocity(const RobotModel& robot);

  void reset() { begun_ = false; }
  /// A cycle of dt [s]: where the links are at its end, the torso's attitude without its heading, how far the
  /// heading turned in the cycle [rad].
  VelocityEvidence update(const ForwardKinematics& kinematics, const Mat3& upright, double turn,
                          const FootSensors& feet, double dt);

private:
  struct Part {
    int link = -1;  ///< -1: the robot has no such part
    Vec3 centre;    ///< of its mass in the link's frame [m]
    Pose3 pose;     ///< about the centre of mass of the robot, upright
  };
  std::array<Part, 4> parts_;  ///< left and right foot, left and right toe
  double mass_;
  bool begun_ = false;
};

}  // namespace plumbline::walking
