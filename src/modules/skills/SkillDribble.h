#pragma once
#include "framework/Module.h"
#include "modules/skills/WalkToPose.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillOutputs.h"

namespace plumbline {

MODULE(SkillDribble)
REQUIRES(SkillRequest)
REQUIRES(RobotPose)
REQUIRES(BallPos)
REQUIRES(SkillGetBallOutput)
PROVIDES(SkillDribbleOutput)
END_MODULE

/// Pushes the ball to a point on the field by walking through it; gets behind it first.
class SkillDribble : public SkillDribbleBase {
public:
  void init() override;
  void update(SkillDribbleOutput* theSkillDribbleOutput) override;

private:
  WalkToPoseParameters walk_;
  double lateralGain_ = 0;                     ///< [1/s]
  double startLateral_ = 0, stopLateral_ = 0;  ///< ball off the line to begin and to break off [m]
  double startHeading_ = 0, stopHeading_ = 0;  ///< heading error likewise [rad]
  double reach_ = 0;                           ///< the ball is lost beyond this distance ahead [m]
  bool pushing_ = false;
};

}  // namespace plumbline
