#include "simulation/referee/rules/Crowding.h"

namespace plumbline::simulation {

namespace {

constexpr double tolerance = 0.01;  ///< [m]

bool opponentNear(Match& match, TeamSide side) {
  for (const Participant& other : match.participants())
    if (other.side == simspark::opponent(side) && other.ballDistance < match.rules.of<Crowding>().minOpponent)
      return true;
  return false;
}

}  // namespace

MAKE_RULE(Crowding, "crowding", 120)

void Crowding::judgePlayer(Match& match, Participant& player) {
  const Parameters& rules = match.rules.of<Crowding>();
  if (!rules.on || player.goalie()) return;
  const TeamSide kickOff = sideOf(match.game.mode, PlayMode::kickOffLeft);
  if (kickOff == player.side || !opponentNear(match, player.side)) return;
  if ((player.ballRank == 3 && player.ballDistance <= rules.minThird + tolerance) ||
      (player.ballRank == 2 && player.ballDistance <= rules.minSecond + tolerance))
    player.commit(Foul::Kind::crowding);
}

}  // namespace plumbline::simulation
