#include "simulation/referee/StartKickOff.h"

#include "simulation/referee/Reposition.h"
#include "simulation/referee/RobotBox.h"

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

}  // namespace plumbline::simulation
