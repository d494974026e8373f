#include "simulation/referee/rules/StartPlace.h"

namespace plumbline::simulation {

MAKE_RULE(StartPlace, "startPlace", 21)

void StartPlace::play(Match& match) {
  const Parameters& rules = match.rules.of<StartPlace>();
  const bool begins = match.mode == PlayMode::beforeKickOff &&
                      sideOf(match.game.mode, PlayMode::kickOffLeft) != TeamSide::none;
  if (!rules.on || !begins) return;
  const Vec3 place(rules.x, rules.y, match.field.ballRadius),
      velocity(rules.speedX, rules.speedY, rules.speedZ);
  match.placeBall(place);
  if (velocity.norm() > 0) match.world.setBall(place, velocity);
  if (Participant* first = match.find(TeamSide::left, 1))
    match.move(*first, Vec3(rules.robotX, rules.robotY, first->torso.pose.translation().z()));
}

}  // namespace plumbline::simulation
