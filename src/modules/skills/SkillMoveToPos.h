#pragma once
#include "framework/Module.h"
#include "modules/skills/WalkToPose.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillOutputs.h"

namespace plumbline {

MODULE(SkillMoveToPos)
REQUIRES(SkillRequest)
REQUIRES(RobotPose)
PROVIDES(SkillMoveToPosOutput)
END_MODULE

/// Walks to a pose on the field; stands once it is there.
class SkillMoveToPos : public SkillMoveToPosBase {
public:
  void init() override;
  void update(SkillMoveToPosOutput* theSkillMoveToPosOutput) override;

private:
  WalkToPoseParameters walk_;
  double positionTolerance_ = 0;  ///< [m]
  double headingTolerance_ = 0;   ///< [rad]
  bool arrived_ = false;
};

}  // namespace plumbline
