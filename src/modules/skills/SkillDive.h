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
  PARAMETER(std::string, left, "diveLeft", "", Range(), "motion for a ball on the left")
  PARAMETER(std::string, right, "diveRight", "", Range(), "motion for a ball on the right")
END_MODULE

/// Throws the robot to the side on which the target lies; the robot lies there afterwards.
class SkillDive : public SkillDiveBase {
public:
  void update(SkillDiveOutput* theSkillDiveOutput) override;
};

}  // namespace plumbline
