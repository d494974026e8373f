#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/MotionRequest.h"
#include "representations/skills/SkillOutput.h"
#include "tactics/ChargeGuard.h"

namespace plumbline {

MODULE(SkillCombinator)
  REQUIRES_ALL(SkillOutput)
  REQUIRES(FrameInfo)
  REQUIRES_IF_PROVIDED(RobotPose)
  REQUIRES_IF_PROVIDED(BallPos)
  REQUIRES_IF_PROVIDED(OtherRobots)
  PROVIDES(MotionRequest)
  PARAMETER_GROUP(ChargeGuardParameters, charge, "what keeps a walk from running into opponents")
END_MODULE

/// Hands the output of the first active skill to the motions; without one the robot stands. No walk runs into
/// an opponent that has the ball.
class SkillCombinator : public SkillCombinatorBase {
public:
  void update(MotionRequest* theMotionRequest) override;

private:
  Vec2 withoutCharging(const Vec2& velocity);

  ChargeGuard guard_;
};

}  // namespace plumbline
