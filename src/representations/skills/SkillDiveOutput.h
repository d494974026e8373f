#pragma once
#include "representations/skills/SkillOutput.h"

namespace plumbline {

/// A goalie's dive.
REPRESENTATION_OF(SkillDiveOutput, SkillOutput)
class SkillDiveOutput : public SkillDiveOutputBase {
public:
  SkillDiveOutput() : SkillDiveOutputBase(Skill::dive, "diving") {}
};

}  // namespace plumbline
