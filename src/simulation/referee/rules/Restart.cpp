#include "simulation/referee/rules/Restart.h"

#include <cmath>

#include "simulation/referee/DropBall.h"
#include "simulation/referee/Reposition.h"
#include "simulation/referee/TakenKicks.h"

namespace plumbline::simulation {

using simspark::opponent;

namespace {

constexpr double touchDelay = 0.03;  ///< a touch counts so long after the pause [s]

struct Kind {
  PlayMode left;
  bool indirect;
};
constexpr Kind kinds[] = {{PlayMode::kickInLeft, true},
                          {PlayMode::cornerKickLeft, false},
                          {PlayMode::goalKickLeft, false},
                          {PlayMode::freeKickLeft, true},
                          {PlayMode::directFreeKickLeft, false}};

/// Whether a goal kick is in play: the ball is out of the penalty area and does not just lie on the goal
/// line.
bool hasLeftArea(Match& match, TeamSide side) {
  const Vec2 ball = match.ball().position().head<2>();
  if (penaltyArea(match.field, side).contains(ball)) return false;
  return !match.ball().onField() || std::fabs(ball.y()) > match.field.penaltyWidth / 2 ||
         sign(side) * ball.x() < match.field.length / 2 - match.field.penaltyDepth;
}

void keepOpponentsAway(Match& match, const Kind& kind, TeamSide side) {
  const Rules::Restarts& rules = match.rules.restarts;
  if (!rules.keepDistance) return;
  if (kind.left == PlayMode::goalKickLeft)
    clearArea(match, penaltyArea(match.field, side), rules.moveDistance, opponent(side));
  else
    clearCircle(match, match.memory.kickPosition, rules.distance, rules.moveDistance, opponent(side));
}

void layBallDown(Match& match, TeamSide side) {
  MatchMemory& memory = match.memory;
  if (memory.repelKickers) repel(match, memory.kickPosition, match.rules.restarts.repel, side, 0, false);
  memory.repelKickers = false;
  match.placeBall(memory.kickPosition);
}

void restart(Match& match, const Kind& kind, TeamSide side) {
  const Rules::Time& time = match.rules.time;
  MatchMemory& memory = match.memory;
  if (match.game.modeTime() < time.kickPause) {
    memory.repelKickers = true;
    return;
  }
  forgetKick(match);
  if (kind.left == PlayMode::freeKickLeft || kind.left == PlayMode::directFreeKickLeft)
    memory.kickPosition = outOfPenaltyAreas(match.field, memory.kickPosition);
  keepOpponentsAway(match, kind, side);
  if (time.dropBall > 0 && match.game.modeTime() > time.dropBall) return dropBall(match, memory.kickPosition);
  const bool touched = match.ball().touchedSince(match.game.lastModeChange + time.kickPause + touchDelay) &&
                       !memory.repelKickers;
  if (!touched) return layBallDown(match, side);
  if (kind.left == PlayMode::goalKickLeft && !hasLeftArea(match, side)) return;
  kickTaken(match, kind.indirect);
  match.game.setMode(PlayMode::playOn);
}

}  // namespace

MAKE_RULE(Restart, "restart", 70)

void Restart::play(Match& match) {
  for (const Kind& kind : kinds)
    if (const TeamSide side = sideOf(match.mode, kind.left); side != TeamSide::none)
      return restart(match, kind, side);
}

}  // namespace plumbline::simulation
