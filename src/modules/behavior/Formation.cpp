#include "modules/behavior/Formation.h"

#include <algorithm>
#include <cmath>

#include "framework/DrawingSite.h"
#include "modules/behavior/RestartModes.h"
#include "modules/behavior/formation/PlanDrawing.h"
#include "tactics/RollingBall.h"

namespace plumbline {

MAKE_MODULE(Formation)

namespace {
constexpr double rounding = 1;       ///< of times that are said [s]: from never less this on means never
constexpr double kickedAway = 1;     ///< words of a ball that rests farther off are old [m]
constexpr double touchReach = 0.4;   ///< a robot this near has touched the ball [m]
constexpr double wordSeconds = 0.3;  ///< within which the referee's word follows a kick [s]
constexpr double inField = 0.4;      ///< places stay this far inside the lines [m]
}  // namespace

void Formation::init() {
  table_ = FormationTable(config.file("formation"));
  pieces_ = SetPieces(config);
  piece_ = nullptr;
  side_ = {};
}

double Formation::timeOf(const TeamBelief& said) const {
  const bool old = said.ballKnown && (restingPlace(said.ball, said.ballVelocity) - ball_).norm() > kickedAway;
  if (!old || said.timeToBall >= PlayerRole::never - rounding) return said.timeToBall;
  return timeToBall(said.pose, said.fallen, ball_, theFieldDimensions->opponentGoal(), time);
}

std::vector<TeamMember> Formation::members(const PlayerRole& own) const {
  std::vector<TeamMember> members;
  for (const TeamReport& report : theTeamRobotPose->reports) {
    const TeamBelief& said = report.belief;
    if (!said.localised && said.number != thePlayerInfo->number) continue;
    members.push_back({said.number, said.pose, said.fallen, said.role, timeOf(said)});
  }
  // Before the first own words: what they would be.
  if (!theTeamRobotPose->of(thePlayerInfo->number))
    members.push_back(
        {thePlayerInfo->number, theRobotPose->pose, theFallState->lying(), own.role, own.timeToBall});
  for (const OtherRobot& robot : theOtherRobots->robots) {
    if (!robot.mate || robot.number < 1 || theFrameInfo->time - robot.lastSeen > seenSeconds) continue;
    if (std::ranges::find(members, robot.number, &TeamMember::number) != members.end()) continue;
    const Vec2 way = ball_ - robot.position;
    const Pose2 pose(robot.position, std::atan2(way.y(), way.x()));
    members.push_back({robot.number, pose, robot.fallen, PlayerRole::none,
                       timeToBall(pose, robot.fallen, ball_, theFieldDimensions->opponentGoal(), time)});
  }
  return members;
}

void Formation::watchRestart(PlayerRole& role) {
  const TeamPlayMode mode = theGameState->playMode;
  const double now = theFrameInfo->time;
  const bool near = theBallPos->valid && theBallPos->relative.norm() < kickReach;
  if (theFrameInfo->restarted) takenAt_ = nearAt_ = -1;
  // A hard kick is out of reach before the referee's word comes.
  if (mode != modeBefore_ && isOwnRestart(mode)) nearAt_ = -1;
  if (near && (isOwnRestart(mode) || isOwnRestart(modeBefore_))) nearAt_ = now;
  const bool takes = nearAt_ >= 0 && now - nearAt_ < wordSeconds;
  if (isOwnRestart(modeBefore_) && mode == TeamPlayMode::playOn && takes && role.members > 1) takenAt_ = now;
  modeBefore_ = mode;
  if (takenAt_ < 0) return;
  const bool touched = std::ranges::any_of(theOtherRobots->robots, [&](const OtherRobot& robot) {
    return (robot.position - theBallPos->field).norm() < touchReach;
  });
  if (touched || mode != TeamPlayMode::playOn || now - takenAt_ > secondTouchWait) takenAt_ = -1;
}

Vec2 Formation::keptOff(const Vec2& place) const {
  const bool restart = isOpponentRestart(theGameState->playMode);
  const double clearance = restart ? restartClearance : ballClearance;
  const Vec2 half(theFieldDimensions->length / 2 - inField, theFieldDimensions->width / 2 - inField);
  Vec2 kept = place;
  if (theGameState->playMode == TeamPlayMode::goalKickOpponent) {
    const double edge = theFieldDimensions->length / 2 - theFieldDimensions->penaltyDepth - inField;
    if (std::abs(kept.y()) < theFieldDimensions->penaltyWidth / 2 + inField)
      kept.x() = std::min(kept.x(), edge);
  }
  if (theGameState->playMode == TeamPlayMode::kickOffOwn ||
      theGameState->playMode == TeamPlayMode::kickOffOpponent)
    kept.x() = std::min(kept.x(), -inField);
  const Vec2 away = kept - ball_;
  if (away.norm() < clearance) {
    // Off the ball to the side of the own goal, where the player stands in the way.
    const Vec2 home = Vec2(-theFieldDimensions->length / 2, 0) - ball_;
    const Vec2 direction = restart || away.norm() < 0.1 ? Vec2(home.normalized()) : Vec2(away.normalized());
    kept = ball_ + clearance * (restart ? Vec2((away + 2 * clearance * direction).normalized()) : direction);
  }
  const auto inside = [&half](const Vec2& p) {
    return Vec2(std::clamp(p.x(), -half.x(), half.x()), std::clamp(p.y(), -half.y(), half.y()));
  };
  kept = inside(kept);
  // Pushed back to the ball by a line: along the line instead.
  if ((kept - ball_).norm() < clearance - 0.2) {
    const double side = kept.y() > ball_.y() ? 1 : -1;
    const double fits = std::abs(ball_.y() + side * clearance) < half.y() ? side : -side;
    kept = inside(Vec2(kept.x(), ball_.y() + fits * clearance));
  }
  return kept;
}

/// The one of this play mode, or of the one before for as long as it lasts in play.
const SetPiece* Formation::setPiece() {
  if (const SetPiece* now = pieces_.of(theGameState->playMode)) {
    piece_ = now;
    side_.update(now, ball_);
    pieceSeen_ = theFrameInfo->time;
  } else if (piece_ && (theGameState->playMode != TeamPlayMode::playOn || theFrameInfo->restarted ||
                        theFrameInfo->time - pieceSeen_ > piece_->lasts)) {
    piece_ = nullptr;
    side_ = {};
  }
  return piece_;
}

/// The nearest of the places is that of who blocks an opponent. The first two stay: they belong to the ball.
void Formation::block(std::vector<Vec2>& places) const {
  if (!theBlockPosition || !theBlockPosition->valid || places.size() < 3) return;
  const auto nearest = std::ranges::min_element(places.begin() + 2, places.end(), {}, [&](const Vec2& place) {
    return (place - theBlockPosition->position).norm();
  });
  if ((*nearest - theBlockPosition->position).norm() < blockReach)
    *nearest = keptOff(theBlockPosition->position);
}

std::vector<Vec2> Formation::places() {
  const Vec2& ball = ball_;
  const SetPiece* piece = setPiece();
  std::vector<Vec2> places;
  for (int i = 0; i < table_.size(); ++i) {
    const auto place = static_cast<std::size_t>(i);
    places.push_back(
        keptOff(piece && place < piece->places.size()
                    ? piece->places[place].at(ball, theFieldDimensions->length / 2, side_.onRight())
                    : table_.at(i, ball)));
  }
  if (!piece) block(places);
  return places;
}

Pose2 Formation::facingBall(const Vec2& place) const {
  const Vec2 toBall = ball_ - place;
  return Pose2(place, std::atan2(toBall.y(), toBall.x()));
}

void Formation::update(TeamPlaces* theTeamPlaces) { theTeamPlaces->players = placed_; }

void Formation::update(PlayerRole* thePlayerRole) {
  PlayerRole& role = *thePlayerRole;
  watchRestart(role);
  role.mayTouchBall = takenAt_ < 0;
  const Vec2 velocity = theRobotPose->pose.rotation() * theBallPos->relativeVelocity;
  ball_ = restingPlace(theBallPos->field, velocity);
  const Vec2 meeting = meetingPlace(theRobotPose->pose.position, time.walkSpeed, theBallPos->field, velocity);
  const bool knows = theRobotPose->valid && theBallPos->valid && role.mayTouchBall;
  role.timeToBall =
      knows ? std::min(PlayerRole::never, timeToBall(theRobotPose->pose, theFallState->lying(), meeting,
                                                     theFieldDimensions->opponentGoal(), time))
            : PlayerRole::never;
  const std::vector<TeamMember> team = members(role);
  role.members = static_cast<int>(team.size());
  role.keeper = thePlayerInfo->number == plan.goalieNumber;

  const std::vector<Vec2> all = places();
  const TeamPlan made = planTeam(team, ball_, theFieldDimensions->size(), all, time, plan);
  role.strikerNumber = made.strikerNumber;
  const OwnArea area(theFieldDimensions->size());
  const auto placeOf = [&](std::size_t i) {
    const Vec2& place = all[static_cast<std::size_t>(made.roles[i] - PlayerRole::supporter)];
    return facingBall(made.rights[i] ? place : area.keptOut(place, OwnArea::waitDistance));
  };
  for (std::size_t i = 0; i < team.size(); ++i) {
    if (team[i].number != thePlayerInfo->number) continue;
    role.role = made.roles[i];
    role.mayBeInOwnArea = made.rights[i];
    if (role.supports()) role.place = placeOf(i);
  }
  placed_.clear();
  for (std::size_t i = 0; i < team.size(); ++i) {
    if (!theTeamRobotPose->of(team[i].number)) continue;  // only seen: its heading is not known
    PlacedPlayer player;
    player.number = team[i].number;
    player.heading = team[i].pose.heading;
    player.placed = made.roles[i] >= PlayerRole::supporter;
    if (player.placed) player.place = placeOf(i);
    placed_.push_back(player);
  }
  DEBUG_DRAWING("draw:team:role", drawRole(drawing, theRobotPose->pose.position, thePlayerInfo->number,
                                           role.role, ball_, all, colours::white));
  DEBUG_DRAWING("draw:Formation:plan", drawPlan(drawing, team, made.roles, ball_, all));
}

}  // namespace plumbline
