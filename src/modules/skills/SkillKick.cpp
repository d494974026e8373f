#include "modules/skills/SkillKick.h"

namespace plumbline {

MAKE_MODULE(SkillKick)

void SkillKick::update(SkillKickOutput* theSkillKickOutput) {
  SkillKickOutput& output = *theSkillKickOutput;
  output.takeOver(*theSkillGetBallOutput);
  output.active = theSkillRequest->skill == Skill::kick;
  // The motions finish a kick that has begun; here only the moment to begin is chosen. In a duel, too, the
  // walk comes to rest first: out of a step the ball goes 30 % less far, and hardly sooner.
  if (!output.active || !theSkillGetBallOutput->atBall) return;
  output.motion = Motion::kick;
}

}  // namespace plumbline
