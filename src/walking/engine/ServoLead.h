#pragma once
#include <array>
#include <vector>

#include "robot/HumanoidModel.h"
#include "walking/engine/LegLoad.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// Command to the servos.
struct ServoCommand {
  std::vector<double> target;     ///< per joint [rad]
  std::vector<double> stiffness;  ///< per joint, 0 .. 1
};

/// What the servos are to do.
struct ServoTargets {
  const JointArray& angles;     ///< [rad], of
  const JointFlags& set;        ///< these joints
  const JointArray& stiffness;  ///< 0 .. 1
  double leftShare = 0.5;       ///< of the weight on the left foot when the command takes effect
};

/// Commands with which position servos reach their targets: a servo deviates under the robot's weight by
/// torque / kp and lags by kd / kp; the shares servo.loadLead and servo.rateLead of these are compensated.
class ServoLead {
public:
  /// Throws std::invalid_argument for a robot that is no humanoid (Humanoid).
  explicit ServoLead(const Mechanism& mechanism);
  ServoLead(const ServoLead&) = delete;
  ServoLead& operator=(const ServoLead&) = delete;

  const Mechanism& mechanism() const { return mechanism_; }
  const Humanoid& humanoid() const { return robot_; }

  void reset();
  /// p: the walk's parameters now. torsoAngles: roll and pitch [rad]. dt: of a cycle [s]. Joints that are not
  /// set go to 0.
  const ServoCommand& command(const ServoTargets& wanted, const WalkParameters& p, const Vec2& torsoAngles,
                              double dt);

private:
  const Mechanism mechanism_;
  const Humanoid robot_;
  LegLoad load_;
  ServoCommand command_;
  JointArray last_{};
  std::array<double, 2> share_{};  ///< of the weight, as it is thought to be when the command takes effect
  bool begun_ = false;
};

}  // namespace plumbline::walking
