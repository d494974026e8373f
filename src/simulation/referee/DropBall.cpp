#include "simulation/referee/DropBall.h"

#include <cmath>

#include "simulation/referee/Reposition.h"
#include "simulation/referee/TakenKicks.h"

namespace plumbline::simulation {

void dropBall(Match& match, Vec3 place) {
  place = outOfPenaltyAreas(match.field, place);
  if (std::fabs(place.y()) >= match.field.width / 2)
    place.y() = std::copysign(match.field.width / 2 - match.field.ballRadius, place.y());
  match.placeBall(place);
  const Rules::Restarts& rules = match.rules.restarts;
  if (rules.keepDistance)
    for (const TeamSide side : match.sidesInRandomOrder())
      clearCircle(match, place, rules.distance, rules.moveDistance, side);
  forgetKick(match);
  match.game.setMode(PlayMode::playOn);
}

}  // namespace plumbline::simulation
