#pragma once
#include "representations/skills/SkillOutput.h"

namespace plumbline {

/// Kicking the ball to a point on the field.
REPRESENTATION_OF(SkillKickOutput, SkillOutput)
class SkillKickOutput : public SkillKickOutputBase {
public:
  SkillKickOutput() : SkillKickOutputBase(Skill::kick, "going to kick", BallApproach::kick) {}
};

}  // namespace plumbline
