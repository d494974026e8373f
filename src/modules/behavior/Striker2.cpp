#include "modules/behavior/Striker2.h"

#include <algorithm>
#include <cmath>

#include "modules/behavior/Restarts.h"

namespace plumbline {

MAKE_MODULE(Striker2)

Striker2::Shot Striker2::shot() const {
  const Vec2 goal = theFieldDimensions->opponentGoal();
  const Vec2& ball = theBallPos->field;
  const auto angleTo = [&](double y) { return std::atan2(y - ball.y(), goal.x() - ball.x()); };
  const double left = angleTo(theFieldDimensions->goalWidth / 2 - goalMargin);
  const double right = angleTo(-theFieldDimensions->goalWidth / 2 + goalMargin);
  const double direction = (left + right) / 2;
  // As far as the goal's middle: how it is brought there depends on the distance.
  const double distance = std::max((goal - ball).norm(), 0.5);
  return {Vec2(ball + distance * Vec2(std::cos(direction), std::sin(direction))), (left - right) / 2,
          distance};
}

bool Striker2::inDuel() const {
  return theOtherRobots && nearestOpponent(theOtherRobots->robots, theBallPos->field) < duelDistance;
}

Vec2 Striker2::wayOn(const Shot& best, bool inReach) {
  const Vec2& ball = theBallPos->field;
  if (!theOtherRobots || theOtherRobots->robots.empty() || inReach) {
    lastAngle_ = 100;
    return best.target;
  }
  const Vec2 toGoal = best.target - ball;
  KickSituation situation;
  situation.robot = theRobotPose->pose;
  situation.ball = ball;
  situation.toGoal = std::atan2(toGoal.y(), toGoal.x());
  situation.reach = theSkillKickParameters->reach();
  situation.halfWidth = theFieldDimensions->width / 2;
  situation.others = theOtherRobots->robots;
  const Vec2& near = theBallPos->relative;
  if (inDuel() && near.norm() < duelReach && near.x() > 0) {
    // No time to go round: where the robot faces, as far as that is forward.
    const double off = normalizeAngle(theRobotPose->pose.heading - situation.toGoal);
    lastAngle_ = normalizeAngle(situation.toGoal + std::clamp(off, -duelWidest, duelWidest));
  } else {
    lastAngle_ = chooseKick(situation, lastAngle_, choice);
  }
  return ball + best.distance * Vec2(std::cos(lastAngle_), std::sin(lastAngle_));
}

double Striker2::kickBeforeTheLine(double toGoal) const {
  double longest = 0;
  for (const Kick& one : theSkillKickParameters->kicks)
    if (one.distance <= toGoal - lineDistance) longest = std::max(longest, one.distance);
  return longest;
}

void Striker2::update(StrikerOutput* theStrikerOutput) {
  BehaviorOutput& output = *theStrikerOutput;
  output.clear();
  output.active = true;
  output.skill = Skill::stand;
  if (theGameState->playMode == PlayMode::gameOver || theGameState->playMode == PlayMode::unknown) return;

  const Pose2& robot = theRobotPose->pose;
  if (!theRobotPose->valid || !theBallPos->valid || theBallPos->age > ballMaxAge) {
    // Turn on the spot: what is lost comes into view, landmarks too.
    output.skill = Skill::moveToPos;
    output.target = Pose2(robot.position, normalizeAngle(robot.heading + 1.0));
    return;
  }
  if (isOpponentRestart(theGameState->playMode)) {
    Vec2 away = Vec2(-theFieldDimensions->length / 2, 0) - theBallPos->field;
    away = away.norm() > 1e-3 ? Vec2(away.normalized()) : Vec2(-1, 0);
    const Vec2 toBall = -away;
    output.skill = Skill::moveToPos;
    output.target =
        Pose2(Vec2(theBallPos->field + restartDistance * away), std::atan2(toBall.y(), toBall.x()));
    return;
  }
  const Shot best = shot();
  const bool inReach = best.distance < theSkillKickParameters->reach() + 1;
  const bool sure = !inReach || best.halfOpening > minOpening;
  const double way = sure ? best.distance : kickBeforeTheLine(best.distance);
  const bool kick = best.distance > dribbleDistance && way > 0;
  output.skill = kickAllowed && kick ? Skill::kick : Skill::dribble;
  Vec2 target = wayOn(best, inReach);
  if (kick && !sure) target = theBallPos->field + way * (target - theBallPos->field).normalized();
  output.target = Pose2(target);
}

}  // namespace plumbline
