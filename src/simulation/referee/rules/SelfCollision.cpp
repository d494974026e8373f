#include "simulation/referee/rules/SelfCollision.h"

namespace plumbline::simulation {

namespace {

FreezeTimes timesOf(const SelfCollision::Parameters& rules) { return {rules.frozen, rules.thaw}; }

/// True if a joint of the limb is frozen that was free.
bool freeze(Match& match, Participant& player, const Limb& limb) {
  return player.limbs.freeze(limb, match.game.time, timesOf(match.rules.of<SelfCollision>()));
}

void freezeOrCall(Match& match, Participant& player, const LimbCollision& collision) {
  const SelfCollision::Parameters& rules = match.rules.of<SelfCollision>();
  if (rules.putOutside) {
    if (match.game.time - player.lastSelfCollision <= rules.cooldown) return;
    player.lastSelfCollision = match.game.time;
    return player.commit(Foul::Kind::selfCollision);
  }
  const bool one = freeze(match, player, collision.a);
  const bool other = freeze(match, player, collision.b);
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
    player.limbs.thaw(match.game.time, timesOf(rules), match.suspended);
    *player.frozen = player.limbs.joints();
  }
}

}  // namespace plumbline::simulation
