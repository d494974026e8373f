#include "simulation/referee/rules/HalfTime.h"

#include <utility>

namespace plumbline::simulation {

namespace {

void changeSides(Match& match) {
  match.game.swapSides();
  MatchMemory& memory = match.memory;
  memory.ball.swapSides();
  for (Participant& player : memory.participants) player.side = simspark::opponent(player.side);
  for (BallTouch* taker : {&memory.kick.taker, &memory.kickOff.taker})
    taker->side = simspark::opponent(taker->side);
  std::swap(memory.pass[0], memory.pass[1]);
}

}  // namespace

MAKE_RULE(HalfTime, "halfTime", 10)

void HalfTime::begin(Match& match) {
  const Rules::Time& time = match.rules.time;
  Game& game = match.game;
  if (game.half == 1 && game.time >= time.half) {
    if (time.singleHalf) return game.setMode(PlayMode::gameOver);
    game.setMode(PlayMode::beforeKickOff);
    game.half = 2;
    if (time.changeSides) changeSides(match);
    match.changedEnds = time.changeSides;
    return;
  }
  if (game.half == 2 && game.time >= 2 * time.half) game.setMode(PlayMode::gameOver);
}

}  // namespace plumbline::simulation
