#include "simulation/referee/rules/Incapable.h"

namespace plumbline::simulation {

bool incapable(const Match& match, const Participant& player) {
  const Rules::Incapable& rules = match.rules.incapable;
  if (!rules.on) return false;
  return player.onGround > match.cycles(player.goalie() ? rules.goalieOnGround : rules.onGround) ||
         player.notStanding > match.cycles(player.goalie() ? rules.goalieNotStanding : rules.notStanding);
}

}  // namespace plumbline::simulation
