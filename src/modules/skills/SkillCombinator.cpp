#include "modules/skills/SkillCombinator.h"

namespace plumbline {

MAKE_MODULE(SkillCombinator)

void SkillCombinator::update(MotionRequest* theMotionRequest) {
  theMotionRequest->motion = Motion::stand;
  theMotionRequest->walkVelocity = Vec2::Zero();
  theMotionRequest->walkTurn = 0;
  for (const SkillOutput* output : {&theSkillKickOutput->output, &theSkillDribbleOutput->output,
                                    &theSkillGetBallOutput->output, &theSkillMoveToPosOutput->output}) {
    if (!output->active) continue;
    theMotionRequest->motion = output->motion;
    theMotionRequest->walkVelocity = output->walkVelocity;
    theMotionRequest->walkTurn = output->walkTurn;
    theMotionRequest->kickFoot = output->kickFoot;
    theMotionRequest->kickBall = output->kickBall;
    return;
  }
}

}  // namespace plumbline
