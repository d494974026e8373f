#include "modules/motion/JointPDControl.h"

namespace plumbline {

MAKE_MODULE(JointPDControl)

void JointPDControl::init() {
  parameters_.gain = config.get<double>("gain", {0.05, 1});
  parameters_.stopMargin = config.get<double>("stopMargin", {0, 0.2});
  cycle_ = config.get<double>("cycle", {0.001, 0.1});
}

void JointPDControl::update(JointRequestWithSpeeds* theJointRequestWithSpeeds) {
  if (theRobotDescription->type < 0) return;
  if (theRobotDescription->type != type_) {
    type_ = theRobotDescription->type;
    control_.emplace(theRobotDescription->model, parameters_);
    targets_ = theJointData->angles;
  }
  if (theFrameInfo->restarted) {
    control_->reset();
    targets_ = theJointData->angles;
  }
  const JointTargets& wanted = theJointRequest->targets;
  for (std::size_t j = 0; j < numJoints; ++j)
    if (wanted.set[j]) targets_[j] = wanted.angles[j];
  theJointRequestWithSpeeds->speeds = control_->update(theJointData->angles, targets_, cycle_);
}

}  // namespace plumbline
