#include "modules/skills/SkillGetBall.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

MAKE_MODULE(SkillGetBall)

BallApproach SkillGetBall::requestedApproach() const {
  if (theSkillRequest->skill == Skill::getBall) return BallApproach::heading;
  for (const SkillOutput* output : allSkillOutputs)
    if (output->skill == theSkillRequest->skill) return output->approach;
  return BallApproach::none;
}

Vec2 SkillGetBall::kickBallPosition() {
  // The foot on the ball's side, with some reluctance to change it.
  const double side = theBallPos->relative.y();
  if (side > 0.03) foot_ = Side::left;
  if (side < -0.03) foot_ = Side::right;
  Vec2 position = theSkillKickParameters->ballPosition;
  if (foot_ == Side::left) position.y() = -position.y();
  return position;
}

bool SkillGetBall::pressed() const {
  return theOtherRobots && std::ranges::any_of(theOtherRobots->robots, [&](const OtherRobot& robot) {
           return !robot.mate && !robot.fallen &&
                  (robot.position - theBallPos->field).norm() < pressedDistance;
         });
}

void SkillGetBall::learnBias(const Pose2& T_robot_target) {
  if (T_robot_target.position.norm() > biasDistance || std::abs(T_robot_target.heading) > 0.5) {
    bias_ = Vec2::Zero();
    return;
  }
  bias_ += biasGain * theFrameInfo->cycleSeconds * T_robot_target.position;
  if (const double size = bias_.norm(); size > maxBias) bias_ *= maxBias / size;
}

void SkillGetBall::update(SkillGetBallOutput* theSkillGetBallOutput) {
  SkillGetBallOutput& output = *theSkillGetBallOutput;
  output.clear();
  output.atBall = false;
  const BallApproach wanted = requestedApproach();
  if (wanted == BallApproach::none) return;

  output.active = theSkillRequest->skill == Skill::getBall;
  double heading = theSkillRequest->target.heading;
  if (wanted != BallApproach::heading) {
    const Vec2 toTarget = theSkillRequest->target.position - theBallPos->field;
    heading = std::atan2(toTarget.y(), toTarget.x());
  }
  heading = normalizeAngle(heading - theRobotPose->pose.heading);
  const Vec2 place = wanted == BallApproach::dribble ? Vec2(dribbleDistance, 0) : kickBallPosition();
  const Pose2 way = approachBall(theBallPos->relative, heading, place, approach);
  const bool detour =
      theSafeWalkDirection && theSafeWalkDirection->detour && theBallPos->relative.norm() > detourDistance;
  WalkCommand command = detour ? walkPast(theSafeWalkDirection->wayPoint, walk) : walkToPose(way, walk);
  // A walk that drifts would come to rest short of the ball for ever (Seekircher 2015, 4.3).
  learnBias(way);
  command.velocity = limitVelocity(command.velocity + bias_, walk);

  const Vec2 error = theBallPos->relative - place;
  const double looser = pressed() ? pressedTolerance : 1;
  const Vec2 tolerance = looser * theSkillKickParameters->tolerance;
  output.atBall = std::abs(error.x()) < tolerance.x() && std::abs(error.y()) < tolerance.y() &&
                  std::abs(heading) < looser * theSkillKickParameters->headingTolerance;
  output.motion = Motion::walk;
  output.walkVelocity = command.velocity;
  output.walkTurn = command.turn;
  output.kickFoot = foot_;
  output.kickBall = theBallPos->relative;
}

}  // namespace plumbline
