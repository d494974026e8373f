#pragma once
#include "framework/Module.h"
#include "representations/motion/MotionRequest.h"
#include "representations/skills/SkillOutputs.h"

namespace plumbline {

MODULE(SkillCombinator)
REQUIRES(SkillMoveToPosOutput)
REQUIRES(SkillGetBallOutput)
REQUIRES(SkillKickOutput)
REQUIRES(SkillDribbleOutput)
PROVIDES(MotionRequest)
END_MODULE

/// Hands the active skill's output to the motions; without one the robot stands.
class SkillCombinator : public SkillCombinatorBase {
public:
  void update(MotionRequest* theMotionRequest) override;
};

}  // namespace plumbline
