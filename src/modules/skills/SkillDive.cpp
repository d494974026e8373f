#include "modules/skills/SkillDive.h"

namespace plumbline {

MAKE_MODULE(SkillDive)

void SkillDive::update(SkillDiveOutput* theSkillDiveOutput) {
  SkillDiveOutput& output = *theSkillDiveOutput;
  output.clear();
  if (theSkillRequest->skill != Skill::dive) return;
  output.active = true;
  output.motion = Motion::specialAction;
  output.atOnce = true;
  output.specialAction =
      (theRobotPose->pose.inverse() * theSkillRequest->target.position).y() > 0 ? left : right;
}

}  // namespace plumbline
