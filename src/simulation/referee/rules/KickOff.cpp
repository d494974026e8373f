#include "simulation/referee/rules/KickOff.h"

#include "simulation/referee/DropBall.h"
#include "simulation/referee/Reposition.h"
#include "simulation/referee/StartKickOff.h"
#include "simulation/referee/TakenKicks.h"

namespace plumbline::simulation {

using simspark::opponent;

MAKE_RULE(KickOff, "kickOff", 20)

namespace {

void beforeKickOff(Match& match) {
  if (match.memory.agents == 0) return;
  match.placeBall(Vec3(0, 0, match.field.ballRadius));
  if (match.rules.kickOff.ownHalf && !match.rules.moves.startAnywhere)
    for (const TeamSide side : match.sidesInRandomOrder())
      clearArea(match, halfOf(match.field, opponent(side)), match.rules.restarts.moveDistance, side);
  const double after = match.rules.kickOff.after;
  if (after >= 0 && match.game.modeTime() >= after) startKickOff(match, TeamSide::none);
}

void kickingOff(Match& match, TeamSide side) {
  forgetKick(match);
  match.memory.kickOff.mayScore = true;
  clearForKickOff(match, side);
  if (match.rules.time.dropBall > 0 && match.game.modeTime() > match.rules.time.dropBall)
    return dropBall(match, match.ball().position());
  if (!match.ball().touchedSince(match.game.lastModeChange)) return;
  if (match.memory.agents > 2) {
    const bool direct = !match.rules.kickOff.noDirectGoal;
    kickTaken(match, !direct);
    match.memory.kickOff = {direct, match.ball().lastTouch()};
  }
  match.game.setMode(PlayMode::playOn);
}

}  // namespace

void KickOff::begin(Match& match) {
  TakenKickOff& kickOff = match.memory.kickOff;
  if (kickOff.mayScore) return;
  const bool outside = match.ball().position().head<2>().norm() > match.rules.restarts.distance;
  kickOff.mayScore = match.ball().touchedBy(opponent(kickOff.taker.side)) ||
                     (match.ball().touchedBy(kickOff.taker.side) && outside);
}

void KickOff::play(Match& match) {
  if (match.mode == PlayMode::beforeKickOff) {
    match.suspended = true;
    beforeKickOff(match);
  }
  if (const TeamSide side = sideOf(match.mode, PlayMode::kickOffLeft); side != TeamSide::none)
    kickingOff(match, side);
}

}  // namespace plumbline::simulation
