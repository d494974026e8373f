#pragma once
#include "representations/skills/SkillOutput.h"

namespace plumbline {

/// Walking to a pose on the field.
REPRESENTATION_OF(SkillMoveToPosOutput, SkillOutput)
class SkillMoveToPosOutput : public SkillMoveToPosOutputBase {
public:
  SkillMoveToPosOutput() : SkillMoveToPosOutputBase(Skill::moveToPos, "walking") { goesToTarget = true; }
};

}  // namespace plumbline
