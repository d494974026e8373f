#include "simulation/referee/rules/BallOut.h"

#include <cmath>

#include "simulation/referee/rules/Award.h"

namespace plumbline::simulation {

bool ballOut(Match& match) {
  const BallWatch& ball = match.ball();
  if (ball.onField()) {
    match.memory.kickPosition = ball.lastOnField();
    match.memory.kickPosition.z() = match.field.ballRadius;
    return false;
  }
  const TeamSide toucher = ball.lastTouch().side;
  if (!match.rules.ballOut.on || toucher == TeamSide::none) return true;
  if (std::fabs(ball.position().x()) < match.field.length / 2) {
    awardKickIn(match, simspark::opponent(toucher));
    return true;
  }
  const TeamSide end = ball.position().x() < 0 ? TeamSide::left : TeamSide::right;
  if (toucher == end)
    awardCornerKick(match, simspark::opponent(end));
  else
    awardGoalKick(match, end);
  return true;
}

}  // namespace plumbline::simulation
