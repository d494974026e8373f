#include "modules/skills/SkillMoveToPos.h"

#include <cmath>

namespace plumbline {

MAKE_MODULE(SkillMoveToPos)

void SkillMoveToPos::update(SkillMoveToPosOutput* theSkillMoveToPosOutput) {
  SkillMoveToPosOutput& output = *theSkillMoveToPosOutput;
  output.clear();
  if (theSkillRequest->skill != Skill::moveToPos) {
    arrived_ = sprinting_ = false;
    planner_.leave();
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
  const bool detour = theSafeWalkDirection && theSafeWalkDirection->detour;
  WalkPoint robot{target.inverse()};
  WalkLimits limits;
  if (theWalkingEngineOutput) {
    const WalkingEngineOutput& now = *theWalkingEngineOutput;
    robot.speed = Vec3(now.velocity.x(), now.velocity.y(), now.turn);
    limits = now.limits;
  }
  const bool plans = !detour && ApproachPlanner::plansFrom(target.position.norm(), sprinting_, limits, plan);
  if (!plans) planner_.leave();
  const WalkCommand command = plans    ? planner_.update(robot, limits, plan)
                              : detour ? walkPast(theSafeWalkDirection->wayPoint, walk, sprinting_)
                                       : walkToPose(target, walk, sprinting_);
  sprinting_ = command.sprint;
  output.motion = Motion::walk;
  output.walkVelocity = command.velocity;
  output.walkTurn = command.turn;
}

}  // namespace plumbline
