#include "modules/skills/SkillGetBall.h"

#include <algorithm>
#include <cmath>

#include "framework/DrawingSite.h"
#include "tactics/RollingBall.h"

namespace plumbline {

namespace {

constexpr double farAway = 1e3;  // [m]

/// A planned way in the frame of its place, and where the robot looks on it and at its end.
void drawPlan(Drawing& drawing, const Pose2& T_robot_place, const std::vector<Pose2>& way) {
  constexpr std::size_t between = 5;  // poses, 0.3 s
  if (way.empty()) return;
  drawing.in(DrawingFrame::robot, T_robot_place);
  for (std::size_t i = 1; i < way.size(); ++i)
    drawing.line(way[i - 1].position, way[i].position, colours::cyan);
  for (std::size_t i = 0; i < way.size(); i += between) drawing.pose(way[i], 0.08, colours::cyan);
  drawing.pose({}, 0.2, colours::yellow);
}

}  // namespace

MAKE_MODULE(SkillGetBall)

BallApproach SkillGetBall::requestedApproach(const SkillOutput& own) const {
  if (theSkillRequest->skill == own.skill) return own.approach;
  const SkillOutput* skill = findSkill(allSkillOutputs, theSkillRequest->skill);
  return skill ? skill->approach : BallApproach::none;
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

void SkillGetBall::update(SkillGetBallOutput* theSkillGetBallOutput) {
  SkillGetBallOutput& output = *theSkillGetBallOutput;
  output.clear();
  output.atBall = false;
  output.pressed = theOtherRobots && theOtherRobots->nearestOpponent(theBallPos->field) < pressedDistance;
  const BallApproach wanted = requestedApproach(output);
  if (wanted == BallApproach::none) {
    positioning_.leave();
    return;
  }

  output.active = theSkillRequest->skill == output.skill;
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
  BallPositioning::Wish wish{.ball = ball,
                             .heading = normalizeAngle(heading - theRobotPose->pose.heading),
                             .place = place,
                             .hurry = output.pressed ? pressedTolerance : 1};
  if (theWalkingEngineOutput) {
    wish.speed = theWalkingEngineOutput->speed();
    wish.limits = theWalkingEngineOutput->limits;
  }
  if (output.pressed) wish.headingTolerance = std::max(pressedHeading, positioning.toleranceHeading);
  if (theSkillRequest->tolerance > 0) wish.headingTolerance = theSkillRequest->tolerance;
  if (wanted == BallApproach::dribble && ball.norm() > runUp) wish.beyond = dribbleOn;
  const bool detour = theSafeWalkDirection && theSafeWalkDirection->detour && ball.norm() > detourDistance;
  if (detour) wish.detour = theSafeWalkDirection->wayPoint;
  const WalkCommand command =
      positioning_.update(wish, theBallPos->relative, positioning, theFrameInfo->cycleSeconds);
  DEBUG_DRAWING("draw:SkillGetBall:plan", drawPlan(drawing, BallPositioning::placeOf(wish),
                                                   positioning_.plannedWay(wish, positioning)));
  output.atBall = positioning_.atBall();
  output.motion = Motion::walk;
  output.walkVelocity = command.velocity;
  output.walkTurn = command.turn;
  output.kickFoot = theActiveFoot->foot;
  output.kickBall = theBallPos->relative;
}

}  // namespace plumbline
