#pragma once
#include "parameters/Parameter.h"
#include "robot/RobotModel.h"

namespace plumbline {

struct JointVelocityParameters {
  PARAMETERS(JointVelocityParameters)
  PARAMETER(double, gain, 1, "", Range(0.05, 1),
            "share of the predicted error removed in one cycle; 1 reaches the target at once")
  PARAMETER(double, stopMargin, 0.01, "rad", Range(0, 0.2),
            "targets keep this far from the stops of the joints, which bounce")
};

/// Turns joint targets into motor speeds for a platform whose command answers a measurement one cycle late.
/// When a speed takes effect the joint has already moved with the speed commanded before it. So the error is
/// relative to that prediction, and a target is reached in the second measurement after it was set.
class JointVelocityControl {
public:
  explicit JointVelocityControl(const RobotModel& model, const JointVelocityParameters& parameters = {});

  /// Speeds [rad/s] that move the joints from the measured angles to the targets [rad]; dt is the cycle [s].
  /// Joints the robot lacks get 0.
  const JointArray& update(const JointArray& measured, const JointArray& targets, double dt);
  void setParameters(const JointVelocityParameters& changed);
  /// Angles the joints will have when the next command takes effect [rad].
  const JointArray& predicted() const { return predicted_; }
  /// Forgets the command in flight (after a reconnect).
  void reset() { speeds_.fill(0); }

private:
  JointVelocityParameters parameters_;
  JointArray lowerStop_{}, upperStop_{}, maxSpeed_{};
  JointArray lower_{}, upper_{};  ///< of the targets, inside the stops [rad]
  JointArray speeds_{}, predicted_{};
};

}  // namespace plumbline
