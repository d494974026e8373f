#pragma once
#include "framework/Module.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/WalkingEngineOutput.h"
#include "representations/skills/SafeWalkDirection.h"
#include "representations/skills/SkillMoveToPosOutput.h"
#include "tactics/approach/WalkToPlace.h"

namespace plumbline {

MODULE(SkillMoveToPos)
  REQUIRES(SkillRequest)
  REQUIRES(RobotPose)
  REQUIRES_IF_PROVIDED(SafeWalkDirection)
  USES(WalkingEngineOutput)
  PROVIDES(SkillMoveToPosOutput)
  PARAMETER_GROUP(WalkToPoseParameters, walk, "limits and gains of walking to a pose")
  PARAMETER_GROUP(ApproachPlannerParameters, plan, "the last metres, where the walk's limits are known")
  PARAMETER(double, positionTolerance, 0.05, "m", Range(0, 1), "the robot has arrived when it is nearer")
  PARAMETER(double, headingTolerance, 0.15, "rad", Range(0, 3.2),
            "the robot has arrived when its heading is off by less")
END_MODULE

/// Walks to a pose on the field, round others where SafeWalkDirection says so; stands once it is there.
class SkillMoveToPos : public SkillMoveToPosBase {
public:
  void update(SkillMoveToPosOutput* theSkillMoveToPosOutput) override;

private:
  WalkToPlace way_;
  bool arrived_ = false;
};

}  // namespace plumbline
