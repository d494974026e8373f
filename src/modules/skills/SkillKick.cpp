#include "modules/skills/SkillKick.h"

namespace plumbline {

MAKE_MODULE(SkillKick)

void SkillKick::update(SkillKickOutput* theSkillKickOutput) {
  SkillKickOutput& output = *theSkillKickOutput;
  output.takeOver(*theSkillGetBallOutput);
  output.active = theSkillRequest->skill == Skill::kick;
  // The motions finish a kick that has begun; here only the moment to begin is chosen.
  if (output.active && theSkillGetBallOutput->atBall) output.motion = Motion::kick;
}

}  // namespace plumbline
