#pragma once
#include "representations/skills/SkillOutput.h"

namespace plumbline {

/// Walking to the ball.
REPRESENTATION_OF(SkillGetBallOutput, SkillOutput)
class SkillGetBallOutput : public SkillGetBallOutputBase {
public:
  SkillGetBallOutput() : SkillGetBallOutputBase(Skill::getBall, "going to the ball", BallApproach::heading) {}

  bool atBall = false;   ///< the robot stands at the ball as the requested skill wants it
  bool pressed = false;  ///< an opponent is so near to the ball that there is no time to stand exactly
  void stream(InStream* in, OutStream* out) override {
    SkillOutput::stream(in, out);
    STREAM(atBall);
    STREAM(pressed);
  }
};

}  // namespace plumbline
