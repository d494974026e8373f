#include "simulation/referee/rules/BallOut.h"

#include <cmath>

#include "simulation/referee/Award.h"

namespace plumbline::simulation {

MAKE_RULE(BallOut, "ballOut", 60)

void BallOut::play(Match& match) {
  if (!match.ballInPlay() || match.settled) return;
  const BallWatch& ball = match.ball();
  if (ball.onField()) {
    match.memory.kickPosition = ball.lastOnField();
    match.memory.kickPosition.z() = match.field.ballRadius;
    return;
  }
  match.settled = true;
  const TeamSide toucher = ball.lastTouch().side;
  if (!match.rules.of<BallOut>().on || toucher == TeamSide::none) return;
  if (std::fabs(ball.position().x()) < match.field.length / 2)
    return awardKickIn(match, simspark::opponent(toucher));
  const TeamSide end = ball.position().x() < 0 ? TeamSide::left : TeamSide::right;
  if (toucher == end)
    awardCornerKick(match, simspark::opponent(end));
  else
    awardGoalKick(match, end);
}

}  // namespace plumbline::simulation
