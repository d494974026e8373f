#include "modules/behavior/striker/KickChoice.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr double farAway = 1e3;     ///< [m]
constexpr double outCost = 3;       ///< of a ball kicked off the field [m]
constexpr double lineMargin = 0.3;  ///< [m]

double nearest(const std::vector<OtherRobot>& others, const Vec2& place, bool mate) {
  double best = farAway;
  for (const OtherRobot& robot : others)
    if (robot.mate == mate && !robot.fallen) best = std::min(best, (robot.position - place).norm());
  return best;
}

bool blocked(const KickSituation& situation, const Vec2& direction, double width) {
  return std::ranges::any_of(situation.others, [&](const OtherRobot& robot) {
    const Vec2 to = robot.position - situation.ball;
    const double along = to.dot(direction);
    return along > 0 && along < situation.reach &&
           std::abs(to.x() * direction.y() - to.y() * direction.x()) < width;
  });
}

}  // namespace

double nearestOpponent(const std::vector<OtherRobot>& others, const Vec2& place) {
  return nearest(others, place, false);
}

double chooseKick(const KickSituation& situation, double last, const KickChoiceParameters& parameters) {
  const bool pressed = nearestOpponent(situation.others, situation.ball) < parameters.pressedDistance;
  const double turnCost = pressed ? parameters.pressedTurnCost : parameters.turnCost;
  const Vec2 toBall = situation.ball - situation.robot.position;
  const double facing = std::atan2(toBall.y(), toBall.x());
  double bestGain = -farAway, best = situation.toGoal;
  for (int i = 0; i < parameters.directions; ++i) {
    const double off = parameters.widest * (2.0 * i / (parameters.directions - 1) - 1);
    const double angle = normalizeAngle(situation.toGoal + off);
    const Vec2 direction(std::cos(angle), std::sin(angle));
    const Vec2 end = situation.ball + situation.reach * direction;
    double gain = situation.reach * std::cos(off) - turnCost * std::abs(normalizeAngle(angle - facing));
    if (blocked(situation, direction, parameters.blockWidth)) gain -= parameters.blockCost;
    if (std::abs(end.y()) > situation.halfWidth - lineMargin) gain -= outCost;
    const double mates = nearest(situation.others, end, true),
                 opponents = nearestOpponent(situation.others, end);
    gain += std::clamp(parameters.mateGain * (opponents - mates), -parameters.mostMateGain,
                       parameters.mostMateGain);
    if (std::abs(normalizeAngle(angle - last)) < parameters.widest / parameters.directions)
      gain += parameters.stays;
    if (gain <= bestGain) continue;
    bestGain = gain;
    best = angle;
  }
  return best;
}

}  // namespace plumbline
