#include "modules/skills/SkillDive.h"

namespace plumbline {

MAKE_MODULE(SkillDive)

void SkillDive::update(SkillDiveOutput* theSkillDiveOutput) {
  SkillDiveOutput& output = *theSkillDiveOutput;
  output.clear();
  output.active = theSkillRequest->skill == Skill::dive;
  if (!output.active) return;
  const Vec2 target = (theRobotPose->pose.inverse() * theSkillRequest->target).position;
  output.motion = Motion::specialAction;
  output.specialAction = target.y() > 0 ? "diveLeft" : "diveRight";
}

}  // namespace plumbline
