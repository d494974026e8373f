#pragma once
#include "framework/Module.h"
#include "modules/skills/BallApproach.h"
#include "modules/skills/WalkToPose.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillKickParameters.h"
#include "representations/skills/SkillOutputs.h"

namespace plumbline {

MODULE(SkillGetBall)
  REQUIRES(SkillRequest)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(SkillKickParameters)
  PROVIDES(SkillGetBallOutput)
END_MODULE

/// Walks to the ball without touching it and takes a heading there: for getBall the requested one, for a kick
/// or a dribble the direction to where the ball shall go.
class SkillGetBall : public SkillGetBallBase {
 public:
  void init() override;
  void update(SkillGetBallOutput* theSkillGetBallOutput) override;

 private:
  Vec2 kickBallPosition();

  WalkToPoseParameters walk_;
  BallApproachParameters approach_;
  Vec2 dribbleBall_ = Vec2::Zero();  ///< where the ball lies in the robot's frame before a dribble [m]
  Side foot_ = Side::right;
};

}  // namespace plumbline
