#include "simulation/referee/rules/KickOff.h"

#include <algorithm>

#include "simulation/referee/Reposition.h"
#include "simulation/referee/RobotBox.h"
#include "simulation/referee/rules/DoubleTouch.h"
#include "simulation/referee/rules/DropBall.h"

namespace plumbline::simulation {

using simspark::opponent;

void startKickOff(Match& match, TeamSide side) {
  MatchMemory& memory = match.memory;
  if (side == TeamSide::none) {
    side = match.random.uniform(0, 1) <= 0.5 ? TeamSide::left : TeamSide::right;
    if (match.game.half != memory.lastKickOffHalf) {
      if (memory.nextHalfKickOff != TeamSide::none) side = memory.nextHalfKickOff;
      memory.nextHalfKickOff = match.rules.time.changeSides ? side : opponent(side);
    }
  }
  match.game.setMode(modeOf(PlayMode::kickOffLeft, side));
  memory.lastKickOffHalf = match.game.half;
}

void beforeKickOff(Match& match) {
  if (match.memory.agents == 0) return;
  match.placeBall(Vec3(0, 0, match.field.ballRadius));
  if (match.rules.kickOff.ownHalf && !match.rules.moves.startAnywhere)
    for (const TeamSide side : match.sidesInRandomOrder())
      clearArea(match, halfOf(match.field, opponent(side)), match.rules.restarts.moveDistance, side);
  const auto& after = match.rules.kickOff.after;
  if (after && match.game.modeTime() >= *after) startKickOff(match, TeamSide::none);
}

void clearForKickOff(Match& match, TeamSide side) {
  if (!match.rules.kickOff.ownHalf || match.rules.moves.startAnywhere) return;
  const Rules::Restarts& rules = match.rules.restarts;
  clearArea(match, halfOf(match.field, side), rules.moveDistance, opponent(side));
  clearCircle(match, Vec3::Zero(), rules.distance, rules.moveDistance, opponent(side));

  const Area otherHalf = halfOf(match.field, opponent(side));
  for (Participant* player : match.inRandomOrder(side)) {
    const Area area = robotArea(match.world, *player);
    if (!otherHalf.meets(area)) continue;
    const Vec2 farthest = area.low.cwiseAbs().cwiseMax(area.high.cwiseAbs());
    if (farthest.norm() < rules.distance) continue;  // all of it in the ring
    Vec3 place = player->torso.pose.translation();
    place.x() = sign(side) * rules.moveDistance;
    moveSafely(match, *player, place);
  }
}

void kickingOff(Match& match, TeamSide side) {
  forgetKick(match);
  match.memory.kickOff.mayScore = true;
  clearForKickOff(match, side);
  if (match.rules.time.dropBall > 0 && match.game.modeTime() > match.rules.time.dropBall)
    return dropBall(match, match.ball().position());
  if (!match.ball().touchedSince(match.game.lastModeChange)) return;
  if (match.memory.agents > 2) {
    const bool direct = !match.rules.kickOff.noDirectGoal;
    kickTaken(match, !direct);
    match.memory.kickOff = {direct, match.ball().lastTouch()};
  }
  match.game.setMode(PlayMode::playOn);
}

void watchKickOff(Match& match) {
  TakenKickOff& kickOff = match.memory.kickOff;
  if (kickOff.mayScore) return;
  const bool outside = match.ball().position().head<2>().norm() > match.rules.restarts.distance;
  kickOff.mayScore = match.ball().touchedBy(opponent(kickOff.taker.side)) ||
                     (match.ball().touchedBy(kickOff.taker.side) && outside);
}

}  // namespace plumbline::simulation
