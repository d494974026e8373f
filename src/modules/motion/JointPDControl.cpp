#include "modules/motion/JointPDControl.h"

namespace plumbline {

MAKE_MODULE(JointPDControl)

void JointPDControl::parametersChanged() {
  if (control_) control_->setParameters(control);
}

void JointPDControl::update(JointRequestWithSpeeds* theJointRequestWithSpeeds) {
  if (!theRobotDescription->known()) return;
  if (theRobotDescription->name != robot_) {
    robot_ = theRobotDescription->name;
    control_.emplace(theRobotDescription->model, control);
    targets_ = theJointData->angles;
  }
  if (theFrameInfo->restarted) {
    control_->reset();
    targets_ = theJointData->angles;
  }
  const JointTargets& wanted = theJointRequest->targets;
  for (std::size_t j = 0; j < maxJoints; ++j)
    if (wanted.set[j]) targets_[j] = wanted.angles[j];
  theJointRequestWithSpeeds->speeds = control_->update(theJointData->angles, targets_, cycle);
}

}  // namespace plumbline
