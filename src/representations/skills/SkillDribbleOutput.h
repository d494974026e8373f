#pragma once
#include "representations/skills/SkillOutput.h"

namespace plumbline {

/// Pushing the ball to a point on the field.
REPRESENTATION_OF(SkillDribbleOutput, SkillOutput)
class SkillDribbleOutput : public SkillDribbleOutputBase {
public:
  SkillDribbleOutput() : SkillDribbleOutputBase(Skill::dribble, "dribbling", BallApproach::dribble) {}
};

}  // namespace plumbline
