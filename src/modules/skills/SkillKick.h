#pragma once
#include "framework/Module.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/skills/SkillGetBallOutput.h"
#include "representations/skills/SkillKickOutput.h"

namespace plumbline {

MODULE(SkillKick)
  REQUIRES(SkillRequest)
  REQUIRES(SkillGetBallOutput)
  PROVIDES(SkillKickOutput)
END_MODULE

/// Walks to the ball and kicks it towards a point on the field.
class SkillKick : public SkillKickBase {
public:
  void update(SkillKickOutput* theSkillKickOutput) override;
};

}  // namespace plumbline
