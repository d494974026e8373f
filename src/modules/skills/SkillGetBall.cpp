#include "modules/skills/SkillGetBall.h"

#include <algorithm>
#include <cmath>

#include "tactics/RollingBall.h"

namespace plumbline {

namespace {
constexpr double farAway = 1e3;  // [m]
}

MAKE_MODULE(SkillGetBall)

BallApproach SkillGetBall::requestedApproach() const {
  if (theSkillRequest->skill == Skill::getBall) return BallApproach::heading;
  for (const SkillOutput* output : allSkillOutputs)
    if (output->skill == theSkillRequest->skill) return output->approach;
  return BallApproach::none;
}

const Kick& SkillGetBall::chooseKick(double metres) {
  const SkillKickParameters& all = *theSkillKickParameters;
  const Kick& shorter = all.kickFor(metres - kickMargin);
  const Kick& chosen = shorter.motion == kick_                            ? shorter
                       : all.kickFor(metres + kickMargin).motion == kick_ ? all.kickFor(metres + kickMargin)
                                                                          : all.kickFor(metres);
  kick_ = chosen.motion;
  return chosen;
}

void SkillGetBall::learnBias(const Pose2& T_robot_target) {
  if (T_robot_target.position.norm() > biasDistance || std::abs(T_robot_target.heading) > 0.5) {
    bias_ = Vec2::Zero();
    return;
  }
  bias_ += biasGain * theFrameInfo->cycleSeconds * T_robot_target.position;
  if (const double size = bias_.norm(); size > maxBias) bias_ *= maxBias / size;
}

bool SkillGetBall::exact(const Vec2& error, double heading, bool pressed) const {
  const double hurry = pressed ? pressedTolerance : 1, stays = atBall_ ? keeps : 1;
  const Vec2 tolerance = hurry * stays * theSkillKickParameters->tolerance;
  const double most = theSkillRequest->tolerance > 0 ? theSkillRequest->tolerance
                                                     : hurry * theSkillKickParameters->headingTolerance;
  return std::abs(error.x()) < tolerance.x() && std::abs(error.y()) < tolerance.y() &&
         std::abs(heading) < stays * most;
}

void SkillGetBall::update(SkillGetBallOutput* theSkillGetBallOutput) {
  SkillGetBallOutput& output = *theSkillGetBallOutput;
  output.clear();
  output.atBall = false;
  output.pressed = theOtherRobots && theOtherRobots->nearestOpponent(theBallPos->field) < pressedDistance;
  const BallApproach wanted = requestedApproach();
  if (wanted == BallApproach::none) {
    atBall_ = sprinting_ = false;
    return;
  }

  output.active = theSkillRequest->skill == Skill::getBall;
  const double mirror = theActiveFoot->foot == Side::left ? -1 : 1;
  double heading = theSkillRequest->target.heading;
  Vec2 place(dribbleDistance, 0);
  // Where the ball will be when the robot is there, in its frame.
  const Vec2 ball =
      meetingPlace(Vec2::Zero(), meetingSpeed, theBallPos->relative, theBallPos->relativeVelocity);
  const Vec2 rolls = theRobotPose->pose.rotation() * (ball - theBallPos->relative);
  const Vec2 toTarget = theSkillRequest->target.position - (theBallPos->field + rolls);
  if (wanted != BallApproach::heading) heading = std::atan2(toTarget.y(), toTarget.x());
  if (wanted != BallApproach::dribble) {
    const Kick& kick = chooseKick(wanted == BallApproach::kick ? toTarget.norm() : farAway);
    place = Vec2(kick.ballPosition.x(), mirror * kick.ballPosition.y());
    if (wanted == BallApproach::kick) heading -= mirror * kick.direction;
    output.kick = kick.motion;
  }
  heading = normalizeAngle(heading - theRobotPose->pose.heading);
  Pose2 way = approachBall(ball, heading, place, approach);
  const bool fromBehind = std::abs(way.heading - heading) < 1e-9 && ball.norm() > runUp;
  if (wanted == BallApproach::dribble && fromBehind)
    way.position += dribbleOn * Vec2(std::cos(heading), std::sin(heading));
  const bool detour = theSafeWalkDirection && theSafeWalkDirection->detour && ball.norm() > detourDistance;
  WalkCommand command =
      detour ? walkPast(theSafeWalkDirection->wayPoint, walk, sprinting_) : walkToPose(way, walk, sprinting_);
  sprinting_ = command.sprint;
  // A walk that drifts would come to rest short of the ball for ever (Seekircher 2015, 4.3).
  if (!atBall_) learnBias(way);
  command.velocity = limitVelocity(command.velocity + bias_, walk);

  atBall_ = output.atBall = exact(theBallPos->relative - place, heading, output.pressed);
  output.motion = Motion::walk;
  output.walkVelocity = command.velocity;
  output.walkTurn = command.turn;
  output.kickFoot = theActiveFoot->foot;
  output.kickBall = theBallPos->relative;
}

}  // namespace plumbline
