#pragma once
#include "representations/skills/SkillOutput.h"

namespace plumbline {

/// Walking to the ball.
REPRESENTATION_OF(SkillGetBallOutput, SkillOutput)
class SkillGetBallOutput : public SkillGetBallOutputBase {
public:
  SkillGetBallOutput() : SkillGetBallOutputBase(Skill::getBall, "going to the ball", BallApproach::heading) {}

  bool atBall = false;  ///< the robot stands at the ball as the requested skill wants it
  void stream(InStream* in, OutStream* out) override {
    SkillOutput::stream(in, out);
    STREAM(atBall);
  }
};

}  // namespace plumbline
