#pragma once
#include "framework/Module.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillDiveOutput.h"

namespace plumbline {

MODULE(SkillDive)
  REQUIRES(SkillRequest)
  REQUIRES(RobotPose)
  PROVIDES(SkillDiveOutput)
END_MODULE

/// Falls to the side on which the target is, by the motion diveRight or its mirror image. The robot then
/// lies, and stands up as after any fall.
class SkillDive : public SkillDiveBase {
public:
  void update(SkillDiveOutput* theSkillDiveOutput) override;
};

}  // namespace plumbline
