#include "simulation/referee/rules/Crowding.h"

namespace plumbline::simulation {

namespace {

constexpr double tolerance = 0.01;  ///< [m]

bool opponentNear(Match& match, TeamSide side) {
  for (const Participant& other : match.participants())
    if (other.side == simspark::opponent(side) && other.ballDistance < match.rules.crowding.minOpponent)
      return true;
  return false;
}

}  // namespace

bool crowds(Match& match, const Participant& player) {
  const Rules::Crowding& rules = match.rules.crowding;
  if (!rules.on || player.goalie()) return false;
  const TeamSide kickOff = sideOf(match.game.mode, PlayMode::kickOffLeft);
  if (kickOff == player.side || !opponentNear(match, player.side)) return false;
  return (player.ballRank == 3 && player.ballDistance <= rules.minThird + tolerance) ||
         (player.ballRank == 2 && player.ballDistance <= rules.minSecond + tolerance);
}

}  // namespace plumbline::simulation
