#include "modules/motion/MotionCombinator.h"

namespace plumbline {

MAKE_MODULE(MotionCombinator)

void MotionCombinator::update(JointRequest* theJointRequest) {
  ratios_.clear();
  const JointTargets* selected = nullptr;
  for (const MotionOutput* output : allMotionOutputs) {
    ratios_.push_back(theMotionSelection->ratio(output->motion));
    if (output->motion == theMotionSelection->motion) selected = &output->targets;
  }
  JointTargets& result = theJointRequest->targets;
  for (std::size_t j = 0; j < maxJoints; ++j) {
    double weight = 0, angle = 0, stiffness = 0;
    for (std::size_t m = 0; m < allMotionOutputs.size(); ++m) {
      const JointTargets& targets = allMotionOutputs[m]->targets;
      if (!targets.set[j] || ratios_[m] <= 0) continue;
      weight += ratios_[m];
      angle += ratios_[m] * targets.angles[j];
      stiffness += ratios_[m] * targets.stiffness[j];
    }
    // A joint nobody moves now keeps its last target.
    if (weight <= 0) continue;
    result.angles[j] = angle / weight;
    result.stiffness[j] = stiffness / weight;
    result.set[j] = true;
  }

  if (!selected || !selected->set[headYaw]) result.setTo(headYaw, theHeadMotionRequest->yaw);
  if (!selected || !selected->set[headPitch]) result.setTo(headPitch, theHeadMotionRequest->pitch);
}

}  // namespace plumbline
