#include "modules/behavior/BehaviorCombinator.h"

#include "framework/DrawingSite.h"

namespace plumbline {

MAKE_MODULE(BehaviorCombinator)

const BehaviorOutput* BehaviorCombinator::active() const {
  for (const BehaviorOutput* output : allBehaviorOutputs)
    if (output->active) return output;
  return nullptr;
}

void BehaviorCombinator::update(SkillRequest* theSkillRequest) {
  const BehaviorOutput* output = active();
  theSkillRequest->skill = output ? output->skill : Skill::stand;
  theSkillRequest->target = output ? output->target : Pose2();
  theSkillRequest->tolerance = output ? output->tolerance : 0;
  DEBUG_DRAWING("draw:BehaviorCombinator:target", {
    if (!output) return;
    drawing.circle(output->target.position, 0.15, colours::red);
    drawing.pose(output->target, 0.4, colours::red);
    drawing.text(output->target.position, output->skill, colours::red);
  });
}

void BehaviorCombinator::update(BeamRequest* theBeamRequest) {
  const BehaviorOutput* output = active();
  theBeamRequest->active = output && output->beam;
  if (theBeamRequest->active) theBeamRequest->pose = output->beamPose;
}

}  // namespace plumbline
