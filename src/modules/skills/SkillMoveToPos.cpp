#include "modules/skills/SkillMoveToPos.h"

#include <cmath>

#include "modules/skills/WalkConfig.h"

namespace plumbline {

MAKE_MODULE(SkillMoveToPos)

void SkillMoveToPos::init() {
  walk_ = readWalkToPose(config);
  positionTolerance_ = config.get<double>("positionTolerance", {0.0, 1.0});
  headingTolerance_ = config.get<double>("headingTolerance", {0.0, 3.2});
}

void SkillMoveToPos::update(SkillMoveToPosOutput* theSkillMoveToPosOutput) {
  SkillOutput& output = theSkillMoveToPosOutput->output;
  output = {};
  if (theSkillRequest->skill != Skill::moveToPos) {
    arrived_ = false;
    return;
  }
  const Pose2 target = theRobotPose->pose.inverse() * theSkillRequest->target;
  // Leaving the target again takes three times the error, so that noise does not make the robot step.
  const double factor = arrived_ ? 3 : 1;
  arrived_ = target.position.norm() < factor * positionTolerance_ &&
             std::abs(target.heading) < factor * headingTolerance_;
  output.active = true;
  if (arrived_) return;
  const WalkCommand command = walkToPose(target, walk_);
  output.motion = Motion::walk;
  output.walkVelocity = command.velocity;
  output.walkTurn = command.turn;
}

}  // namespace plumbline
