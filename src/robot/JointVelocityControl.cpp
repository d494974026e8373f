#include "robot/JointVelocityControl.h"

#include <algorithm>

namespace plumbline {

JointVelocityControl::JointVelocityControl(const RobotModel& model,
                                           const JointVelocityParameters& parameters_)
    : parameters(parameters_) {
  for (std::size_t j = 0; j < numJoints; ++j) {
    if (model.linkOfJoint[j] < 0) continue;
    const Link& link = model.linkMovedBy(static_cast<JointId>(j));
    // A joint whose range includes only a degree beyond zero keeps its zero.
    const double margin = std::min(parameters.stopMargin, (link.upper - link.lower) / 4);
    lower[j] = link.lower + margin;
    upper[j] = link.upper - margin;
    maxSpeed[j] = link.maxSpeed;
  }
}

const JointArray& JointVelocityControl::update(const JointArray& measured, const JointArray& targets,
                                               double dt) {
  for (std::size_t j = 0; j < numJoints; ++j) {
    predicted_[j] = measured[j] + speeds[j] * dt;
    const double target = std::clamp(targets[j], lower[j], upper[j]);
    speeds[j] = std::clamp(parameters.gain * (target - predicted_[j]) / dt, -maxSpeed[j], maxSpeed[j]);
  }
  return speeds;
}

}  // namespace plumbline
