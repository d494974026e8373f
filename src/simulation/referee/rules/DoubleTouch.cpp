#include "simulation/referee/rules/DoubleTouch.h"

#include "simulation/referee/rules/Award.h"

namespace plumbline::simulation {

namespace {
constexpr double kickDuration = 0.1;  ///< [s]
}

void kickTaken(Match& match, bool indirect) {
  match.memory.kick = {true, indirect, match.ball().lastTouch()};
}

void forgetKick(Match& match) {
  match.memory.kick.watched = match.memory.kick.indirect = false;
  for (PassRecord& pass : match.memory.pass) pass.last = Participant::never;
}

bool stillFromKick(Match& match) {
  const BallTouch& taker = match.memory.kick.taker;
  const BallTouch& last = match.ball().lastTouch();
  return taker.side != TeamSide::none && last.side != TeamSide::none &&
         last.time - taker.time < kickDuration && last.samePlayer(taker);
}

bool doubleTouch(Match& match) {
  TakenKick& kick = match.memory.kick;
  if (!kick.watched || kick.taker.side == TeamSide::none || stillFromKick(match)) return false;
  kick.watched = kick.indirect = false;
  if (!match.ball().lastTouch().samePlayer(kick.taker) || !match.rules.restarts.doubleTouch) return false;
  awardFreeKick(match, simspark::opponent(kick.taker.side), true);
  return true;
}

}  // namespace plumbline::simulation
