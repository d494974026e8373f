#pragma once
#include "framework/Module.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/WalkingEngineOutput.h"
#include "representations/skills/ActiveFoot.h"
#include "representations/skills/SafeWalkDirection.h"
#include "representations/skills/SkillGetBallOutput.h"
#include "representations/skills/SkillKickParameters.h"
#include "tactics/approach/BallPositioning.h"

namespace plumbline {

MODULE(SkillGetBall)
  REQUIRES(FrameInfo)
  REQUIRES(SkillRequest)
  USES_ALL(SkillOutput)
  USES(WalkingEngineOutput)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(SkillKickParameters)
  REQUIRES(ActiveFoot)
  REQUIRES_IF_PROVIDED(SafeWalkDirection)
  REQUIRES_IF_PROVIDED(OtherRobots)
  PROVIDES(SkillGetBallOutput)
  PARAMETER_GROUP(BallPositioningParameters, positioning, "the way to the place at the ball")
  PARAMETER(double, pressedDistance, 0.8, "m", Range(0, 5),
            "if an opponent is this near to the ball, there is no time to stand exactly")
  PARAMETER(double, pressedTolerance, 1.75, "", Range(1, 10),
            "then the tolerances of the ball's place are multiplied by this")
  PARAMETER(double, pressedHeading, 0.33, "rad", Range(0.001, 3.2), "and its heading may be off by this")
  PARAMETER(double, detourDistance, 0.8, "m", Range(0, 10),
            "nearer to the ball than this the robot goes straight, even if others stand there")
  PARAMETER(double, dribbleDistance, 0.2, "m", Range(0.05, 1), "the ball ahead of the robot before a dribble")
  PARAMETER(double, dribbleOn, 0.8, "m", Range(0, 5),
            "a robot that comes from behind to dribble aims this far beyond the ball")
  PARAMETER(double, runUp, 0.6, "m", Range(0, 5), "from this far behind the ball at least")
  PARAMETER(double, kickMargin, 0.3, "m", Range(0, 3),
            "a chosen kick stays while the ball's direction is within this of the wanted one")
  PARAMETER(double, meetingSpeed, 0.8, "m/s", Range(0.05, 3),
            "with which the robot meets a rolling ball on its way")
END_MODULE

/// Walks to the ball without touching it and stands there as the requested skill wants it (its BallApproach).
class SkillGetBall : public SkillGetBallBase {
public:
  void update(SkillGetBallOutput* theSkillGetBallOutput) override;

private:
  BallApproach requestedApproach(const SkillOutput& own) const;
  /// The kick for a way of the ball [m], with some reluctance to change it.
  const Kick& chooseKick(double metres);

  BallPositioning positioning_;
  std::string kick_;  ///< the motion of the kick that was chosen last
};

}  // namespace plumbline
