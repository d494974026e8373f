#include "modules/motion/MotionCombinator.h"

namespace plumbline {

MAKE_MODULE(MotionCombinator)

void MotionCombinator::update(JointRequest* theJointRequest) {
  std::array<const JointTargets*, numMotions> motions{};
  motions[static_cast<std::size_t>(Motion::stand)] = &theStandOutput->targets;
  motions[static_cast<std::size_t>(Motion::walk)] = &theWalkingEngineOutput->targets;
  motions[static_cast<std::size_t>(Motion::specialAction)] = &theSpecialActionsOutput->targets;
  motions[static_cast<std::size_t>(Motion::kick)] = &theKickMotionOutput->targets;
  if (theDeadMotionOutput) motions[static_cast<std::size_t>(Motion::dead)] = &theDeadMotionOutput->targets;

  JointTargets& result = theJointRequest->targets;
  for (std::size_t j = 0; j < numJoints; ++j) {
    double weight = 0, angle = 0, hardness = 0;
    for (std::size_t m = 0; m < motions.size(); ++m) {
      const double ratio = theMotionSelection->ratios[m];
      if (!motions[m] || !motions[m]->set[j] || ratio <= 0) continue;
      weight += ratio;
      angle += ratio * motions[m]->angles[j];
      hardness += ratio * motions[m]->hardness[j];
    }
    // A joint nobody moves now keeps its last target.
    if (weight <= 0) continue;
    result.angles[j] = angle / weight;
    result.hardness[j] = hardness / weight;
    result.set[j] = true;
  }

  const JointTargets* selected = motions[static_cast<std::size_t>(theMotionSelection->motion)];
  if (!selected || !selected->set[headYaw]) result.setTo(headYaw, theHeadMotionRequest->yaw);
  if (!selected || !selected->set[headPitch]) result.setTo(headPitch, theHeadMotionRequest->pitch);
}

}  // namespace plumbline
