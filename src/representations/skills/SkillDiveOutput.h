#pragma once
#include "representations/skills/SkillOutput.h"

namespace plumbline {

/// Falling into the way of the ball.
REPRESENTATION_OF(SkillDiveOutput, SkillOutput)
class SkillDiveOutput : public SkillDiveOutputBase {
public:
  SkillDiveOutput() : SkillDiveOutputBase(Skill::dive, "diving") {}
};

}  // namespace plumbline
