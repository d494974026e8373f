#pragma once
#include "robot/RobotModel.h"

namespace plumbline {

struct JointVelocityParameters {
  double gain = 1;           ///< share of the predicted error to remove in one cycle, (0, 1]
  double stopMargin = 0.01;  ///< targets keep this far from the joint limits [rad]; the league's stops bounce
};

/// Turns joint targets into motor speeds for a platform whose command answers a measurement one cycle late:
/// when a speed takes effect the joint has already moved with the speed commanded before it, so the error is
/// taken against that prediction and a target is reached in the second measurement after it was set.
class JointVelocityControl {
public:
  explicit JointVelocityControl(const RobotModel& model, const JointVelocityParameters& parameters = {});

  /// Speeds [rad/s] that move the joints from the measured angles to the targets [rad]; dt is the cycle [s].
  /// Joints the robot lacks get 0.
  const JointArray& update(const JointArray& measured, const JointArray& targets, double dt);
  /// Angles the joints will have when the next command takes effect [rad].
  const JointArray& predicted() const { return predicted_; }
  /// Forgets the command in flight (after a reconnect).
  void reset() { speeds.fill(0); }

private:
  JointVelocityParameters parameters;
  JointArray lower{}, upper{}, maxSpeed{};
  JointArray speeds{}, predicted_{};
};

}  // namespace plumbline
