#include "modules/behavior/Striker2.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/DrawingSite.h"
#include "modules/behavior/Restarts.h"

namespace plumbline {

MAKE_MODULE(Striker2)

void Striker2::init() { value_.emplace(config.file("field_value")); }

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

void Striker2::playAlone(BehaviorOutput& output) const {
  const Shot best = shot();
  const bool inReach = best.distance < theSkillKickParameters->reach() + 1;
  const bool sure = !inReach || best.halfOpening > minOpening;
  const double way = sure ? best.distance : kickBeforeTheLine(best.distance);
  const bool kick = kickAllowed && best.distance > dribbleDistance && way > 0;
  output.skill = kick ? Skill::kick : Skill::dribble;
  const Vec2 direction = (best.target - theBallPos->field).normalized();
  output.target = Pose2(kick && !sure ? Vec2(theBallPos->field + way * direction) : best.target);
}

void Striker2::draw(const StrikerSituation& situation) const {
  DEBUG_DRAWING("draw:Striker2:action", {
    const bool kicks = action_.kind == StrikerAction::Kind::kick;
    drawing.arrow(situation.ball, action_.end, kicks ? colours::red : colours::green, 3);
    drawing.text(action_.end, fmt::format("{} {:.2f}", kicks ? "kick" : "dribble", action_.value),
                 colours::white);
  });
  // What a ball is worth that is nobody's: green ours, red theirs.
  DEBUG_DRAWING("draw:Striker2:value", {
    constexpr double side = 1, most = 0.6;
    for (double x = -situation.halfLength; x < situation.halfLength; x += side)
      for (double y = -situation.halfWidth; y < situation.halfWidth; y += side) {
        const double worth = value_->at({{x + side / 2, y + side / 2}, 0});
        drawing.polygon({Vec2(x, y), Vec2(x + side, y), Vec2(x + side, y + side), Vec2(x, y + side)},
                        colours::faint(worth > 0 ? colours::green : colours::red, most * std::abs(worth)));
      }
  });
}

void Striker2::playAmongOthers(BehaviorOutput& output) {
  StrikerSituation situation;
  situation.robot = theRobotPose->pose;
  situation.ball = theBallPos->field;
  for (const Kick& kick : theSkillKickParameters->kicks) situation.kicks.push_back(kick.distance);
  situation.halfLength = theFieldDimensions->length / 2;
  situation.halfWidth = theFieldDimensions->width / 2;
  situation.goalHalfWidth = theFieldDimensions->goalWidth / 2;
  situation.others = theOtherRobots->robots;
  action_ = chooseAction(situation, action_, *value_, time, choice);
  const bool kick = kickAllowed && action_.kind == StrikerAction::Kind::kick;
  output.skill = kick ? Skill::kick : Skill::dribble;
  // A kick is told how far; what is dribbled goes on.
  const double distance = kick ? action_.reach : std::max((situation.goal() - situation.ball).norm(), 0.5);
  output.target =
      Pose2(Vec2(situation.ball + distance * Vec2(std::cos(action_.direction), std::sin(action_.direction))));
  draw(situation);
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
  if (theOtherRobots && !theOtherRobots->robots.empty()) {
    playAmongOthers(output);
  } else {
    action_ = {};
    playAlone(output);
  }
}

}  // namespace plumbline
