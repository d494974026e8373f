#pragma once
#include "framework/Module.h"
#include "representations/motion/MotionRequest.h"
#include "representations/skills/SkillOutput.h"

namespace plumbline {

MODULE(SkillCombinator)
  REQUIRES_ALL(SkillOutput)
  PROVIDES(MotionRequest)
END_MODULE

/// Hands the output of the first active skill to the motions; without one the robot stands.
class SkillCombinator : public SkillCombinatorBase {
public:
  void update(MotionRequest* theMotionRequest) override;
};

}  // namespace plumbline
