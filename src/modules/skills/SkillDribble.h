#pragma once
#include "framework/Module.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillDribbleOutput.h"
#include "representations/skills/SkillGetBallOutput.h"
#include "tactics/approach/WalkToPose.h"

namespace plumbline {

MODULE(SkillDribble)
  REQUIRES(SkillRequest)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(SkillGetBallOutput)
  PROVIDES(SkillDribbleOutput)
  PARAMETER_GROUP(WalkToPoseParameters, walk, "limits and gains of walking to a pose")
  PARAMETER(double, lateralGain, 4, "1/s", Range(0, 20),
            "sideways speed per metre that the ball is off the middle")
  PARAMETER(double, startLateral, 0.06, "m", Range(0, 1), "ball off the line to the target to begin pushing")
  PARAMETER(double, stopLateral, 0.14, "m", Range(0, 1), "ball off the line to the target to break off")
  PARAMETER(double, startHeading, 0.25, "rad", Range(0, 3.2), "error of the heading to begin pushing")
  PARAMETER(double, stopHeading, 0.6, "rad", Range(0, 3.2), "error of the heading to break off")
  PARAMETER(double, pressedLateral, 0.14, "m", Range(0, 1),
            "startLateral with an opponent near the ball (SkillGetBall.pressedDistance)")
  PARAMETER(double, pressedHeading, 0.6, "rad", Range(0, 3.2), "startHeading then")
  PARAMETER(double, reach, 0.8, "m", Range(0.1, 5), "a ball farther ahead is walked to again")
  PARAMETER(double, duelBehind, 0.13, "m", Range(0, 1),
            "in a duel a ball off the line by stopLateral is met from a place this far behind it")
  PARAMETER(double, duelThrough, 0.5, "m", Range(0, 3),
            "in a duel a ball on the line is walked through to this far beyond it")
END_MODULE

/// Pushes the ball to a point on the field by walking through it; gets behind it first. In a duel, with an
/// opponent near the ball, it goes straight to the ball instead.
class SkillDribble : public SkillDribbleBase {
public:
  void update(SkillDribbleOutput* theSkillDribbleOutput) override;

private:
  bool pushing_ = false;
};

}  // namespace plumbline
