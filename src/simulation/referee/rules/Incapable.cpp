#include "simulation/referee/rules/Incapable.h"

namespace plumbline::simulation {

MAKE_RULE(Incapable, "incapable", 140)

void Incapable::judgePlayer(Match& match, Participant& player) {
  const Parameters& rules = match.rules.of<Incapable>();
  if (!rules.on) return;
  if (player.onGround > match.cycles(player.goalie() ? rules.goalieOnGround : rules.onGround) ||
      player.notStanding > match.cycles(player.goalie() ? rules.goalieNotStanding : rules.notStanding))
    player.commit(Foul::Kind::incapable);
}

}  // namespace plumbline::simulation
