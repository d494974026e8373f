#include "simulation/referee/rules/StartPlace.h"

namespace plumbline::simulation {

MAKE_RULE(StartPlace, "startPlace", 21)

void StartPlace::play(Match& match) {
  const Parameters& rules = match.rules.of<StartPlace>();
  const bool begins = match.mode == PlayMode::beforeKickOff &&
                      sideOf(match.game.mode, PlayMode::kickOffLeft) != TeamSide::none;
  if (!rules.on || !begins) return;
  match.placeBall(Vec3(rules.x, rules.y, match.field.ballRadius),
                  Vec3(rules.speedX, rules.speedY, rules.speedZ));
  if (Participant* first = match.find(TeamSide::left, 1))
    match.move(*first, Vec3(rules.robotX, rules.robotY, first->torso.pose.translation().z()));
}

}  // namespace plumbline::simulation
