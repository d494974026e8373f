#include "modules/behavior/Striker2.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "framework/DrawingSite.h"
#include "modules/behavior/RestartModes.h"
#include "tactics/RollingBall.h"

namespace plumbline {

MAKE_MODULE(Striker2)

void Striker2::init() { value_.emplace(config.file("field_value")); }

void Striker2::draw(const StrikerSituation& situation) const {
  DEBUG_DRAWING("draw:Striker2:action", {
    const bool kicks = action_.kind == StrikerAction::Kind::kick;
    drawing.arrow(situation.ball, action_.end, kicks ? colours::red : colours::green, 3);
    drawing.text(action_.end, fmt::format("{} {:.2f}", kicks ? "kick" : "dribble", action_.value),
                 colours::white);
  });
  // What a ball is worth that is nobody's, by squares of a metre: green ours, red theirs.
  DEBUG_DRAWING("draw:Striker2:value", {
    constexpr double maxOpacity = 0.6;  // share of the colour, where the value is 1
    const int ahead = static_cast<int>(std::ceil(situation.halfLength)),
              aside = static_cast<int>(std::ceil(situation.halfWidth));
    for (int x = -ahead; x < ahead; ++x)
      for (int y = -aside; y < aside; ++y) {
        const double worth = value_->at({{x + 0.5, y + 0.5}, 0});
        drawing.polygon(
            {Vec2(x, y), Vec2(x + 1, y), Vec2(x + 1, y + 1), Vec2(x, y + 1)},
            colours::faint(worth > 0 ? colours::green : colours::red, maxOpacity * std::abs(worth)));
      }
  });
}

StrikerSituation Striker2::situation() const {
  StrikerSituation situation;
  situation.robot = theRobotPose->pose;
  situation.ball = meetingPlace(situation.robot.position, time.walkSpeed, theBallPos->field,
                                situation.robot.rotation() * theBallPos->relativeVelocity);
  if (kickAllowed)
    for (const Kick& kick : theSkillKickParameters->kicks) situation.kicks.push_back(kick);
  situation.halfLength = theFieldDimensions->length / 2;
  situation.halfWidth = theFieldDimensions->width / 2;
  situation.goalHalfWidth = theFieldDimensions->goalWidth / 2;
  situation.goalHeight = theFieldDimensions->goalHeight;
  situation.ballRadius = theFieldDimensions->ballRadius;
  if (theOtherRobots) situation.others = theOtherRobots->robots;
  if (theTeamPlaces) situation.places = *theTeamPlaces;
  if (theGameState->playMode == TeamPlayMode::passOwn)
    situation.freeSeconds = std::max(0.0, passSeconds - (theGameState->time - passSince_));
  situation.opponentSpeed = theOppInfo ? theOppInfo->walkSpeed : time.walkSpeed;
  return situation;
}

void Striker2::play(BehaviorOutput& output) {
  const StrikerSituation now = situation();
  action_ = chooseAction(now, action_, *value_, time, choice, &compared_);
  plays_ = true;
  playedBall_ = now.ball;
  const bool kick = action_.kind == StrikerAction::Kind::kick;
  output.skill = kick ? Skill::kick : Skill::dribble;
  output.tolerance = kick ? std::clamp(action_.tolerance, leastTolerance, mostTolerance) : 0;
  // A kick aims a little nearer than it carries, so that no longer one is taken; what is dribbled
  // goes on.
  constexpr double less = 0.4;  // [m]
  const double distance =
      kick ? std::max(action_.reach - less, less) : std::max((now.goal() - now.ball).norm(), 0.5);
  output.target =
      Pose2(Vec2(now.ball + distance * Vec2(std::cos(action_.direction), std::sin(action_.direction))));
  draw(now);
}

void Striker2::update(StrikerOutput* theStrikerOutput) {
  BehaviorOutput& output = *theStrikerOutput;
  output.clear();
  output.active = true;
  output.skill = Skill::stand;
  plays_ = false;
  if (theGameState->playMode != TeamPlayMode::passOwn) passSince_ = theGameState->time;
  // A goalie or supporter acts by its own behaviour, which comes before this one in modules.cfg: nothing is
  // worked out for it.
  if (thePlayerRole && thePlayerRole->members > 1 &&
      (thePlayerRole->supports() || thePlayerRole->role == PlayerRole::goalie)) {
    action_ = {};
    return;
  }
  if (theGameState->playMode == TeamPlayMode::gameOver || theGameState->playMode == TeamPlayMode::unknown)
    return;

  const Pose2& robot = theRobotPose->pose;
  if (!theRobotPose->valid || !theBallPos->valid || theBallPos->age > ballMaxAge) {
    // What is lost comes into view, landmarks too.
    output.skill = Skill::moveToPos;
    output.target =
        Pose2(robot.position,
              normalizeAngle(robot.heading + search_.turn(theBallPos->relative, theFrameInfo->time)));
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
  play(output);
}

StrikerOption Striker2::optionOf(const StrikerAction& action) const {
  StrikerOption option;
  option.action = Skill::dribble;
  if (action.kind == StrikerAction::Kind::kick) {
    // Kicks are distinguished by how far they carry, as in ActionChoice.
    const auto& kicks = theSkillKickParameters->kicks;
    const auto kick = std::ranges::find(kicks, action.reach, &Kick::distance);
    option.action = kick != kicks.end() && !kick->motion.empty() ? kick->motion : Skill::kick;
  }
  option.end = action.end;
  option.value = action.value;
  option.goal = action.goal;
  return option;
}

void Striker2::update(StrikerDecision* theStrikerDecision) {
  StrikerDecision& decision = *theStrikerDecision;
  decision.valid = plays_;
  decision.ball = playedBall_;
  decision.options.clear();
  if (!plays_) return;
  decision.options.push_back(optionOf(action_));
  std::ranges::stable_sort(compared_, std::greater<>(), &StrikerAction::value);
  for (const StrikerAction& other : compared_) {
    if (decision.options.size() >= StrikerDecision::maxOptions) break;
    const bool chosen =
        other.kind == action_.kind && other.reach == action_.reach && other.direction == action_.direction;
    if (!chosen) decision.options.push_back(optionOf(other));
  }
}

}  // namespace plumbline
