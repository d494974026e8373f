#pragma once
#include "framework/Module.h"
#include "modules/skills/BallApproach.h"
#include "modules/skills/WalkToPose.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/ActiveFoot.h"
#include "representations/skills/SafeWalkDirection.h"
#include "representations/skills/SkillGetBallOutput.h"
#include "representations/skills/SkillKickParameters.h"

namespace plumbline {

MODULE(SkillGetBall)
  REQUIRES(FrameInfo)
  REQUIRES(SkillRequest)
  USES_ALL(SkillOutput)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(SkillKickParameters)
  REQUIRES(ActiveFoot)
  REQUIRES_IF_PROVIDED(SafeWalkDirection)
  REQUIRES_IF_PROVIDED(OtherRobots)
  PROVIDES(SkillGetBallOutput)
  PARAMETER_GROUP(WalkToPoseParameters, walk, "limits and gains of walking to a pose")
  PARAMETER_GROUP(BallApproachParameters, approach, "way around the ball")
  PARAMETER(double, pressedDistance, 0.8, "m", Range(0, 5),
            "if an opponent is this near to the ball, there is no time to stand exactly")
  PARAMETER(double, pressedTolerance, 1.75, "", Range(1, 10),
            "then the tolerances of the kick are multiplied by this")
  PARAMETER(double, detourDistance, 0.8, "m", Range(0, 10),
            "nearer to the ball than this the robot goes straight, even if others stand there")
  PARAMETER(double, dribbleDistance, 0.2, "m", Range(0.05, 1), "the ball ahead of the robot before a dribble")
  PARAMETER(double, dribbleOn, 0.8, "m", Range(0, 5),
            "a robot that comes from behind to dribble aims this far beyond the ball")
  PARAMETER(double, runUp, 0.6, "m", Range(0, 5), "from this far behind the ball at least")
  PARAMETER(double, keeps, 1.4, "", Range(1, 10),
            "a robot at the ball counts as there until its error is this many tolerances")
  PARAMETER(double, kickMargin, 0.3, "m", Range(0, 3),
            "a chosen kick stays while the ball's direction is within this of the wanted one")
  PARAMETER(double, meetingSpeed, 0.8, "m/s", Range(0.05, 3),
            "with which the robot meets a rolling ball on its way")
  PARAMETER(double, biasGain, 1.5, "1/s^2", Range(0, 10),
            "how fast a drift of the walk is learned near the target")
  PARAMETER(double, biasDistance, 0.15, "m", Range(0, 1),
            "closer to the target than this the drift is learned")
  PARAMETER(double, maxBias, 0.15, "m/s", Range(0, 1), "largest drift that is learned")
END_MODULE

/// Walks to the ball without touching it and stands there as the requested skill wants it (its BallApproach).
class SkillGetBall : public SkillGetBallBase {
public:
  void update(SkillGetBallOutput* theSkillGetBallOutput) override;

private:
  BallApproach requestedApproach() const;
  /// The kick for a way of the ball [m], with some reluctance to change it.
  const Kick& chooseKick(double metres);
  /// Whether the robot stands exactly enough, off by `error` [m] and `heading` [rad]. After that, a larger
  /// error is allowed (`keeps`): a walk that alternates between stopping and walking never comes to rest.
  bool exact(const Vec2& error, double heading, bool pressed) const;
  /// The walk's bias near the target: the learnt correction of the requested speed [m/s].
  void learnBias(const Pose2& T_robot_target);

  Vec2 bias_ = Vec2::Zero();  ///< in the robot's frame [m/s]
  bool atBall_ = false, sprinting_ = false;
  std::string kick_;  ///< the motion of the kick that was chosen last
};

}  // namespace plumbline
