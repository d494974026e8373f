#include "simulation/referee/rules/Penalty.h"

#include "simulation/referee/Conduct.h"
#include "simulation/referee/Reposition.h"

namespace plumbline::simulation {

namespace {

void punishPlayer(Match& match, Participant& player) {
  match.game.fouls.add(player.foul, player.side, player.unum);
  if (player.movedForFoul) return forgive(match, player);
  const Rules::Moves& rules = match.rules.moves;
  if (player.foulCycles <= match.cycles(rules.foulHold)) {
    ++player.foulCycles;
    Vec3 place = player.torso.pose.translation();
    place.z() = 1 + 0.01 * player.foulCycles;
    return match.move(player, place);
  }
  Vec3 place = outsidePlace(match.field, match.ball().position(), player.side, player.unum);
  if (rules.foulHold > 0) place.z() = rules.agentRadius;
  moveSafely(match, player, place);
  forgive(match, player);
}

}  // namespace

MAKE_RULE(Penalty, "penalty", 160)

void Penalty::punish(Match& match) {
  for (const TeamSide side : match.sidesInRandomOrder())
    for (Participant* player : match.inRandomOrder(side))
      if (player->offends()) punishPlayer(match, *player);
}

}  // namespace plumbline::simulation
