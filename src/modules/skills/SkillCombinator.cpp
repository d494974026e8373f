#include "modules/skills/SkillCombinator.h"

namespace plumbline {

MAKE_MODULE(SkillCombinator)

void SkillCombinator::update(MotionRequest* theMotionRequest) {
  theMotionRequest->motion = Motion::stand;
  theMotionRequest->walkVelocity = Vec2::Zero();
  theMotionRequest->walkTurn = 0;
  for (const SkillOutput* output : allSkillOutputs) {
    if (!output->active) continue;
    theMotionRequest->motion = output->motion;
    theMotionRequest->walkVelocity = output->walkVelocity;
    theMotionRequest->walkTurn = output->walkTurn;
    theMotionRequest->specialAction = output->specialAction;
    theMotionRequest->kickFoot = output->kickFoot;
    theMotionRequest->kickBall = output->kickBall;
    return;
  }
}

}  // namespace plumbline
