#pragma once
#include "framework/Module.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/MotionRequest.h"
#include "representations/skills/SkillOutput.h"
#include "tactics/ChargeGuard.h"
#include "tactics/OwnArea.h"

namespace plumbline {

MODULE(SkillCombinator)
  REQUIRES_ALL(SkillOutput)
  REQUIRES(FrameInfo)
  REQUIRES_IF_PROVIDED(RobotPose)
  REQUIRES_IF_PROVIDED(BallPos)
  REQUIRES_IF_PROVIDED(OtherRobots)
  REQUIRES_IF_PROVIDED(FieldDimensions)
  REQUIRES_IF_PROVIDED(PlayerRole)
  PROVIDES(MotionRequest)
  PARAMETER_GROUP(ChargeGuardParameters, charge, "what keeps a walk from running into opponents")
  PARAMETER(double, areaBrakeSeconds, 0.6, "s", Range(0.05, 5),
            "until it would be at the own penalty area, at the fastest speed towards it that is allowed")
END_MODULE

/// Hands the output of the first active skill to the motions; without one the robot stands. No walk runs into
/// an opponent that has the ball, nor into the own penalty area without the right to be there.
class SkillCombinator : public SkillCombinatorBase {
public:
  void update(MotionRequest* theMotionRequest) override;

private:
  Vec2 withoutCharging(const Vec2& velocity);
  Vec2 outsideArea(const Vec2& velocity) const;

  ChargeGuard guard_;
};

}  // namespace plumbline
