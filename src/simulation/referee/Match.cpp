#include "simulation/referee/Match.h"

#include <algorithm>
#include <cmath>

namespace plumbline::simulation {

Participant* Match::find(RobotHandle robot) {
  const auto found = std::find_if(participants().begin(), participants().end(),
                                  [robot](const Participant& p) { return p.robot == robot; });
  return found == participants().end() ? nullptr : &*found;
}

Participant* Match::find(TeamSide side, int unum) {
  const auto found =
      std::find_if(participants().begin(), participants().end(),
                   [side, unum](const Participant& p) { return p.side == side && p.unum == unum; });
  return found == participants().end() ? nullptr : &*found;
}

std::vector<Participant*> Match::inRandomOrder(TeamSide side) {
  std::vector<Participant*> order;
  for (Participant& player : participants())
    if (side == TeamSide::none || player.side == side) order.push_back(&player);
  for (std::size_t i = order.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(random.uniform(0, static_cast<double>(i)));
    std::swap(order[i - 1], order[std::min(other, i - 1)]);
  }
  return order;
}

std::array<TeamSide, 2> Match::sidesInRandomOrder() {
  if (random.uniform(0, 1) < 0.5) return {TeamSide::left, TeamSide::right};
  return {TeamSide::right, TeamSide::left};
}

void Match::placeBall(const Vec3& position, const Vec3& velocity) {
  world.setBall(position, velocity);
  ball().placed(position);
  memory.kickPosition = Vec3(position.x(), position.y(), field.ballRadius);
}

void Match::move(Participant& player, const Vec3& place) {
  player.torso.pose.translation() = place;
  player.torso.linearVelocity.setZero();
  player.torso.angularVelocity.setZero();
  player.sinceMoved = 0;
  world.moveRobot(player.robot, player.torso.pose);
}

}  // namespace plumbline::simulation
