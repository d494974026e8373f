#pragma once
#include "framework/Module.h"
#include "modules/skills/BallApproach.h"
#include "modules/skills/WalkToPose.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillKickParameters.h"
#include "representations/skills/SkillOutputs.h"

namespace plumbline {

MODULE(SkillGetBall)
REQUIRES(FrameInfo)
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
  /// The walk's own bias near the target: what the requested speed has to be raised by, learned there [m/s].
  void learnBias(const Pose2& T_robot_target);

  WalkToPoseParameters walk_;
  BallApproachParameters approach_;
  Vec2 dribbleBall_ = Vec2::Zero();  ///< where the ball lies in the robot's frame before a dribble [m]
  double biasGain_ = 0;              ///< [1/s^2]
  double biasDistance_ = 0;          ///< closer to the target than this it is learned [m]
  double maxBias_ = 0;               ///< [m/s]
  Vec2 bias_ = Vec2::Zero();         ///< in the robot's frame [m/s]
  Side foot_ = Side::right;
};

}  // namespace plumbline
