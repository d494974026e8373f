#include "modules/skills/path/PathPlanner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/Angle.h"

namespace plumbline {
namespace {

constexpr int cornersOfObstacle = 8;
constexpr double slack = 0.02;  ///< by which a circle is drawn back from a start or goal within it [m]

bool isFree(const Vec2& a, const Vec2& b, const std::vector<Obstacle>& obstacles) {
  return std::ranges::none_of(obstacles, [&](const Obstacle& obstacle) {
    return distanceToSegment(obstacle.centre, a, b) < obstacle.radius;
  });
}

void keepRelevant(std::vector<Obstacle>& obstacles, const Vec2& start, const Vec2& goal,
                  const PathPlannerParameters& parameters) {
  for (Obstacle& obstacle : obstacles)
    for (const Vec2& end : {start, goal})
      obstacle.radius = std::min(obstacle.radius, (end - obstacle.centre).norm() - slack);
  std::erase_if(obstacles, [&](const Obstacle& obstacle) {
    return obstacle.radius <= 0 || distanceToSegment(obstacle.centre, start, goal) > parameters.corridor;
  });
  const auto count = std::min(obstacles.size(), static_cast<std::size_t>(parameters.maxObstacles));
  std::ranges::stable_sort(obstacles, {}, [&](const Obstacle& obstacle) {
    return distanceToSegment(obstacle.centre, start, goal) + 0.3 * (obstacle.centre - start).norm();
  });
  obstacles.resize(count);
}

std::vector<Vec2> cornersOf(const std::vector<Obstacle>& obstacles, double corner) {
  std::vector<Vec2> corners;
  for (const Obstacle& obstacle : obstacles)
    for (int i = 0; i < cornersOfObstacle; ++i) {
      const double angle = 2 * pi * i / cornersOfObstacle;
      const Vec2 p = obstacle.centre + corner * obstacle.radius * Vec2(std::cos(angle), std::sin(angle));
      const bool inside = std::ranges::any_of(
          obstacles, [&](const Obstacle& other) { return (p - other.centre).norm() < other.radius; });
      if (!inside) corners.push_back(p);
    }
  return corners;
}

}  // namespace

double distanceToSegment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const double length = way.squaredNorm();
  const double share = length > 1e-12 ? std::clamp((point - a).dot(way) / length, 0.0, 1.0) : 0;
  return (a + share * way - point).norm();
}

Vec2 nextWayPoint(const Vec2& start, const Vec2& goal, std::vector<Obstacle> obstacles, const Vec2& last,
                  const PathPlannerParameters& parameters) {
  keepRelevant(obstacles, start, goal, parameters);
  if (isFree(start, goal, obstacles)) return goal;

  std::vector<Vec2> nodes = cornersOf(obstacles, parameters.corner);
  nodes.push_back(goal);
  const std::size_t count = nodes.size(), end = count - 1;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> cost(count, infinite);
  std::vector<std::size_t> first(count, end);
  std::vector<bool> done(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    if (!isFree(start, nodes[i], obstacles)) continue;
    const Vec2 way = nodes[i] - start;
    cost[i] = way.norm();
    if (!last.isZero() && cost[i] > 1e-6)
      cost[i] +=
          parameters.turnCost * std::acos(std::clamp(way.dot(last) / (cost[i] * last.norm()), -1.0, 1.0));
    first[i] = i;
  }
  for (;;) {
    std::size_t here = count;
    for (std::size_t i = 0; i < count; ++i)
      if (!done[i] && cost[i] < infinite && (here == count || cost[i] < cost[here])) here = i;
    if (here == count) return goal;
    if (here == end) return nodes[first[end]];
    done[here] = true;
    for (std::size_t i = 0; i < count; ++i) {
      const double length = (nodes[i] - nodes[here]).norm();
      if (done[i] || cost[here] + length >= cost[i] || !isFree(nodes[here], nodes[i], obstacles)) continue;
      cost[i] = cost[here] + length;
      first[i] = first[here];
    }
  }
}

}  // namespace plumbline
