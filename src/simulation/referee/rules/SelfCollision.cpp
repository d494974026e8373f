#include "simulation/referee/rules/SelfCollision.h"

namespace plumbline::simulation {

namespace {

void freezeOrCall(Match& match, Participant& player, const LimbCollision& collision) {
  const SelfCollision::Parameters& rules = match.rules.of<SelfCollision>();
  if (rules.putOutside) {
    if (match.game.time - player.lastSelfCollision <= rules.cooldown) return;
    player.lastSelfCollision = match.game.time;
    return player.commit(Foul::Kind::selfCollision);
  }
  const bool one = player.limbs.freeze(collision.a, match.game.time, rules.times());
  const bool other = player.limbs.freeze(collision.b, match.game.time, rules.times());
  if (one || other) match.game.fouls.add(Foul::Kind::selfCollision, player.side, player.unum);
}

}  // namespace

MAKE_RULE(SelfCollision, "selfCollision", 110)

void SelfCollision::judgeAll(Match& match) {
  const Parameters& rules = match.rules.of<SelfCollision>();
  if (!rules.on) return;
  for (Participant& player : match.participants()) {
    for (const LimbCollision& collision :
         limbCollisions(match.world, player.robot, *player.model, rules.tolerance))
      freezeOrCall(match, player, collision);
    *player.frozen = player.limbs.joints();
  }
}

void SelfCollision::end(Match& match) {
  const Parameters& rules = match.rules.of<SelfCollision>();
  for (Participant& player : match.participants()) {
    player.limbs.thaw(match.game.time, rules.times(), match.suspended);
    *player.frozen = player.limbs.joints();
  }
}

}  // namespace plumbline::simulation
