#include "robot/JointVelocityControl.h"

#include <algorithm>

namespace plumbline {

JointVelocityControl::JointVelocityControl(const RobotModel& model,
                                           const JointVelocityParameters& parameters) {
  for (std::size_t j = 0; j < maxJoints; ++j) {
    if (model.linkOfJoint[j] < 0) continue;
    const Link& link = model.linkMovedBy(static_cast<JointId>(j));
    lowerStop[j] = link.lower;
    upperStop[j] = link.upper;
    maxSpeed[j] = link.maxSpeed;
  }
  setParameters(parameters);
}

void JointVelocityControl::setParameters(const JointVelocityParameters& changed) {
  parameters = changed;
  for (std::size_t j = 0; j < maxJoints; ++j) {
    // A joint whose range includes only a degree beyond zero keeps its zero.
    const double margin = std::min(parameters.stopMargin, (upperStop[j] - lowerStop[j]) / 4);
    lower[j] = lowerStop[j] + margin;
    upper[j] = upperStop[j] - margin;
  }
}

const JointArray& JointVelocityControl::update(const JointArray& measured, const JointArray& targets,
                                               double dt) {
  for (std::size_t j = 0; j < maxJoints; ++j) {
    predicted_[j] = measured[j] + speeds[j] * dt;
    const double target = std::clamp(targets[j], lower[j], upper[j]);
    speeds[j] = std::clamp(parameters.gain * (target - predicted_[j]) / dt, -maxSpeed[j], maxSpeed[j]);
  }
  return speeds;
}

}  // namespace plumbline
