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
  const bool ahead = ball.x() > 0 && ball.x() < reach;
  pushing_ = ahead && lateral < most && heading < off;
  const bool duel = !pushing_ && pressed && ahead;
  if (!pushing_ && !duel) return;
  Vec2 velocity(walk.maxForward * std::max(0.3, std::cos(direction)), lateralGain * theBallPos->relative.y());
  if (duel) {  // in any direction of the body, while it turns
    const double beyond = std::lerp(duelThrough, -duelBehind, std::min(1.0, lateral / stopLateral));
    const Vec2 way = Eigen::Rotation2Dd(direction) * Vec2(ball.x() + beyond, ball.y());
    velocity = walk.maxForward / std::max(way.norm(), 1e-3) * way;
  }
  output.motion = Motion::walk;
  output.walkVelocity = limitVelocity(velocity, walk);
  output.walkTurn = std::clamp(walk.headingGain * direction, -walk.maxTurn, walk.maxTurn);
}

}  // namespace plumbline
