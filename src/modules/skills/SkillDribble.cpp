#include "modules/skills/SkillDribble.h"

#include <algorithm>
#include <cmath>

#include "modules/skills/WalkConfig.h"

namespace plumbline {

MAKE_MODULE(SkillDribble)

void SkillDribble::init() {
  walk_ = readWalkToPose(config);
  lateralGain_ = config.get<double>("lateralGain", {0.0, 20.0});
  startLateral_ = config.get<double>("startLateral", {0.0, 1.0});
  stopLateral_ = config.get<double>("stopLateral", {0.0, 1.0});
  startHeading_ = config.get<double>("startHeading", {0.0, 3.2});
  stopHeading_ = config.get<double>("stopHeading", {0.0, 3.2});
  reach_ = config.get<double>("reach", {0.1, 5.0});
}

void SkillDribble::update(SkillDribbleOutput* theSkillDribbleOutput) {
  SkillOutput& output = theSkillDribbleOutput->output;
  output = theSkillGetBallOutput->output;
  output.active = theSkillRequest->skill == Skill::dribble;
  if (!output.active) {
    pushing_ = false;
    return;
  }
  const Vec2 toTarget = theSkillRequest->target.position - theBallPos->field;
  const double direction =
      normalizeAngle(std::atan2(toTarget.y(), toTarget.x()) - theRobotPose->pose.heading);
  // The ball in the frame whose x axis is the line to the target through the robot.
  const Vec2 ball = Eigen::Rotation2Dd(-direction) * theBallPos->relative;
  const double lateral = std::abs(ball.y());
  const double heading = std::abs(direction);
  pushing_ = ball.x() > 0 && ball.x() < reach_ &&
             (pushing_ ? lateral < stopLateral_ && heading < stopHeading_
                       : lateral < startLateral_ && heading < startHeading_);
  if (!pushing_) return;
  output.motion = Motion::walk;
  output.walkVelocity = limitVelocity(
      {walk_.maxForward * std::max(0.3, std::cos(direction)), lateralGain_ * theBallPos->relative.y()},
      walk_);
  output.walkTurn = std::clamp(walk_.headingGain * direction, -walk_.maxTurn, walk_.maxTurn);
}

}  // namespace plumbline
