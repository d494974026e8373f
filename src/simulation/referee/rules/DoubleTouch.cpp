#include "simulation/referee/rules/DoubleTouch.h"

#include "simulation/referee/Award.h"
#include "simulation/referee/TakenKicks.h"

namespace plumbline::simulation {

MAKE_RULE(DoubleTouch, "doubleTouch", 40)

void DoubleTouch::play(Match& match) {
  if (!match.ballInPlay() || match.settled) return;
  TakenKick& kick = match.memory.kick;
  if (!kick.watched || kick.taker.side == TeamSide::none || stillFromKick(match)) return;
  kick.watched = kick.indirect = false;
  if (!match.ball().lastTouch().samePlayer(kick.taker) || !match.rules.restarts.doubleTouch) return;
  awardFreeKick(match, simspark::opponent(kick.taker.side), true);
  match.settled = true;
}

}  // namespace plumbline::simulation
