#include "simulation/referee/TakenKicks.h"

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

}  // namespace plumbline::simulation
