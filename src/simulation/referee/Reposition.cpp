#include "simulation/referee/Reposition.h"

#include <cmath>

#include "simulation/referee/RobotBox.h"
#include "simulation/referee/SafePlace.h"

namespace plumbline::simulation {

namespace {

/// `distance` from the centre towards a side's own goal, or sideways if that is behind the goal line.
void stepBack(const FieldSize& field, Vec3& place, const Vec2& centre, double distance, TeamSide side) {
  const double x = centre.x() + sign(side) * distance;
  if (std::fabs(x) > field.length / 2 && x * sign(side) > 0)
    place.y() = centre.y() + (centre.y() < 0 ? distance : -distance);
  else
    place.x() = x;
}

}  // namespace

void moveSafely(Match& match, Participant& player, const Vec3& place, bool avoidBall) {
  match.move(player, safePlace(match, player, place, avoidBall));
}

Vec3 outsidePlace(const FieldSize& field, const Vec3& ball, TeamSide side, int unum) {
  const double y = field.width / 2 + 0.5;
  return Vec3(sign(side) * 0.6 * (7 - unum), ball.y() < 0 ? y : -y, 1);
}

void clearCircle(Match& match, const Vec3& centre, double radius, double distance, TeamSide side) {
  for (Participant* player : match.inRandomOrder(side)) {
    if ((player->place() - centre.head<2>()).norm() > radius + 2) continue;  // no robot is that long
    if (!robotBox(match.world, *player).reachedBy(centre, radius)) continue;
    Vec3 place = player->torso.pose.translation();
    stepBack(match.field, place, centre.head<2>(), distance, side);
    moveSafely(match, *player, place);
  }
}

void clearArea(Match& match, const Area& area, double distance, TeamSide side) {
  for (Participant* player : match.inRandomOrder(side)) {
    if (!area.meets(robotArea(match.world, *player))) continue;
    Vec3 place = player->torso.pose.translation();
    place.x() = side == TeamSide::left ? area.low.x() - distance : area.high.x() + distance;
    moveSafely(match, *player, place);
  }
}

void repel(Match& match, const Vec3& centre, double radius, TeamSide side, double further, bool avoidBall) {
  for (Participant* player : match.inRandomOrder(side)) {
    const Vec2 way = player->place() - centre.head<2>();
    if (way.norm() >= radius) continue;
    const Vec2 direction = way.norm() > 0 ? Vec2(way.normalized()) : Vec2(sign(side), 0);
    Vec3 place = player->torso.pose.translation();
    place.head<2>() = centre.head<2>() + direction * (radius + further);
    moveSafely(match, *player, place, avoidBall);
  }
}

void clearSelected(Match& match) {
  for (Participant* player : match.inRandomOrder(TeamSide::none)) {
    if (!player->selected) continue;
    Vec3 place = player->torso.pose.translation();
    stepBack(match.field, place, player->place(), match.rules.restarts.moveDistance, player->side);
    moveSafely(match, *player, place);
  }
}

}  // namespace plumbline::simulation
