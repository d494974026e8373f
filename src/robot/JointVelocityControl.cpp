#include "robot/JointVelocityControl.h"

#include <algorithm>

namespace plumbline {

JointVelocityControl::JointVelocityControl(const RobotModel& model,
                                           const JointVelocityParameters& parameters) {
  for (std::size_t j = 0; j < maxJoints; ++j) {
    if (model.linkOfJoint[j] < 0) continue;
    const Link& link = model.linkMovedBy(static_cast<JointId>(j));
    lowerStop_[j] = link.lower;
    upperStop_[j] = link.upper;
    maxSpeed_[j] = link.maxSpeed;
  }
  setParameters(parameters);
}

void JointVelocityControl::setParameters(const JointVelocityParameters& changed) {
  parameters_ = changed;
  for (std::size_t j = 0; j < maxJoints; ++j) {
    // A joint whose range includes only a degree beyond zero keeps its zero.
    const double margin = std::min(parameters_.stopMargin, (upperStop_[j] - lowerStop_[j]) / 4);
    lower_[j] = lowerStop_[j] + margin;
    upper_[j] = upperStop_[j] - margin;
  }
}

const JointArray& JointVelocityControl::update(const JointArray& measured, const JointArray& targets,
                                               double dt) {
  for (std::size_t j = 0; j < maxJoints; ++j) {
    predicted_[j] = measured[j] + speeds_[j] * dt;
    const double target = std::clamp(targets[j], lower_[j], upper_[j]);
    speeds_[j] = std::clamp(parameters_.gain * (target - predicted_[j]) / dt, -maxSpeed_[j], maxSpeed_[j]);
  }
  return speeds_;
}

}  // namespace plumbline
