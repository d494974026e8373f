#pragma once
#include "framework/Module.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/ActiveFoot.h"
#include "representations/skills/SkillOutput.h"
#include "tactics/approach/FootChoice.h"

namespace plumbline {

MODULE(FootSelector)
  REQUIRES(SkillRequest)
  USES_ALL(SkillOutput)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES_IF_PROVIDED(OtherRobots)
  PROVIDES(ActiveFoot)
  PARAMETER_GROUP(FootChoiceParameters, foot, "which foot plays the ball")
  PARAMETER(double, opponentDistance, 0.8, "m", Range(0, 5),
            "an opponent this near to the ball is screened off")
  PARAMETER(double, screenShift, 0.04, "m", Range(0, 1),
            "then the robot counts as so much nearer to the side that the opponent is on")
END_MODULE

/// Chooses the foot that plays the ball (Seekircher 2015, A.3): the one that reaches the place behind the
/// ball sooner. A robot to the left of the ball's direction has the ball in front of its right foot. If both
/// feet are equally good and an opponent is at the ball, the robot goes between the two.
class FootSelector : public FootSelectorBase {
public:
  void update(ActiveFoot* theActiveFoot) override;
};

}  // namespace plumbline
