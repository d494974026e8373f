#include "simulation/referee/rules/IllegalDefence.h"

#include <cmath>

#include "simulation/referee/Reposition.h"

namespace plumbline::simulation {

namespace {

double nearerEdge(double low, double high, double value, double margin) {
  return std::fabs(low - value) < std::fabs(high - value) ? low - margin : high + margin;
}

bool defendsIllegally(Match& match, const Participant& player) {
  const Rules::IllegalDefence& rules = match.rules.illegalDefence;
  if (!rules.on || player.goalie() || !player.inOwnArea ||
      match.memory.inOwnArea[Game::index(player.side)] <= rules.maxInOwnArea)
    return false;
  if (!player.wasInOwnArea) return true;
  const Participant* goalie = match.find(player.side, 1);
  return goalie && goalie->inOwnArea && !goalie->wasInOwnArea && player.goalRank == rules.maxInOwnArea + 1;
}

void punishDefence(Match& match, Participant& player) {
  player.commit(Foul::Kind::illegalDefence, !match.rules.illegalDefence.putOutside);
  --match.memory.inOwnArea[Game::index(player.side)];
  if (match.rules.illegalDefence.putOutside) return;
  const double radius = match.rules.moves.agentRadius;
  const Area area = penaltyArea(match.field, player.side);
  Vec3 place = player.torso.pose.translation();
  const double x = nearerEdge(area.low.x(), area.high.x(), place.x(), radius);
  const double y = nearerEdge(area.low.y(), area.high.y(), place.y(), radius);
  if (std::fabs(y - place.y()) < std::fabs(x - place.x()))
    place.y() = y;
  else
    place.x() = x;
  if (std::fabs(place.x()) > match.field.length / 2 &&
      std::fabs(place.y()) < match.field.goalWidth / 2 + radius)
    place.y() = (match.field.goalWidth / 2 + radius + 0.001) * (place.y() < 0 ? -1 : 1);
  moveSafely(match, player, place);
}

}  // namespace

MAKE_RULE(IllegalDefence, "illegalDefence", 130)

void IllegalDefence::judgePlayer(Match& match, Participant& player) {
  if (defendsIllegally(match, player)) punishDefence(match, player);
}

}  // namespace plumbline::simulation
