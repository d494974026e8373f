#include "modules/skills/SkillMoveToPos.h"

#include <cmath>

namespace plumbline {

MAKE_MODULE(SkillMoveToPos)

void SkillMoveToPos::update(SkillMoveToPosOutput* theSkillMoveToPosOutput) {
  SkillMoveToPosOutput& output = *theSkillMoveToPosOutput;
  output.clear();
  if (theSkillRequest->skill != Skill::moveToPos) {
    arrived_ = false;
    way_.leave();
    return;
  }
  const Pose2 target = theRobotPose->pose.inverse() * theSkillRequest->target;
  // Leaving the target again takes three times the error, so that noise does not make the robot step.
  const double factor = arrived_ ? 3 : 1;
  arrived_ = target.position.norm() < factor * positionTolerance &&
             std::abs(target.heading) < factor * headingTolerance;
  output.active = true;
  if (arrived_) return;
  if (theSafeWalkDirection && theSafeWalkDirection->wait) return;
  std::optional<Vec2> detour;
  if (theSafeWalkDirection && theSafeWalkDirection->detour) detour = theSafeWalkDirection->wayPoint;
  Vec3 speed = Vec3::Zero();
  WalkLimits limits;
  if (theWalkingEngineOutput) {
    speed = theWalkingEngineOutput->speed();
    limits = theWalkingEngineOutput->limits;
  }
  const WalkCommand command = way_.update(target, speed, limits, detour, walk, plan);
  output.motion = Motion::walk;
  output.walkVelocity = command.velocity;
  output.walkTurn = command.turn;
}

}  // namespace plumbline
