#include "modules/skills/SkillKick.h"

namespace plumbline {

MAKE_MODULE(SkillKick)

void SkillKick::update(SkillKickOutput* theSkillKickOutput) {
  SkillKickOutput& output = *theSkillKickOutput;
  output.takeOver(*theSkillGetBallOutput);
  output.active = theSkillRequest->skill == Skill::kick;
  // The motions finish a kick that has begun; here only the moment to begin is chosen.
  if (!output.active || !theSkillGetBallOutput->atBall) return;
  output.motion = Motion::kick;
  // In a duel a shorter kick now is worth more than a longer one from a walk that has come to rest.
  output.atOnce = theSkillGetBallOutput->pressed;
}

}  // namespace plumbline
