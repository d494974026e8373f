#include "modules/skills/SkillDribble.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

MAKE_MODULE(SkillDribble)

void SkillDribble::update(SkillDribbleOutput* theSkillDribbleOutput) {
  SkillDribbleOutput& output = *theSkillDribbleOutput;
  output.takeOver(*theSkillGetBallOutput);
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
  const bool pressed = theSkillGetBallOutput->pressed;
  const double most = pushing_ ? stopLateral : pressed ? pressedLateral : startLateral;
  const double off = pushing_ ? stopHeading : pressed ? pressedHeading : startHeading;
  pushing_ = ball.x() > 0 && ball.x() < reach && lateral < most && heading < off;
  if (!pushing_ && pressed && ball.x() > 0 && ball.x() < reach) {
    // A duel: straight to the ball in any direction of the body, while it turns.
    const double off = std::min(1.0, lateral / stopLateral);
    const Vec2 aim(ball.x() + std::lerp(through, -behind, off), ball.y());
    const Vec2 way = Eigen::Rotation2Dd(direction) * aim;
    output.motion = Motion::walk;
    output.walkVelocity = limitVelocity(walk.maxForward / std::max(way.norm(), 1e-3) * way, walk);
    output.walkTurn = std::clamp(walk.headingGain * direction, -walk.maxTurn, walk.maxTurn);
    return;
  }
  if (!pushing_) return;
  output.motion = Motion::walk;
  output.walkVelocity = limitVelocity(
      {walk.maxForward * std::max(0.3, std::cos(direction)), lateralGain * theBallPos->relative.y()}, walk);
  output.walkTurn = std::clamp(walk.headingGain * direction, -walk.maxTurn, walk.maxTurn);
}

}  // namespace plumbline
