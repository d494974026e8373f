#include "modules/skills/path/PathPlanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/Angle.h"

namespace plumbline {
namespace {

constexpr int cornersOfObstacle = 8;
constexpr double sightStep = 0.05;  ///< between the points of a path that are looked at [m]
constexpr double touch = 1e-9;      ///< by which a circle that start or goal lies on is none they lie in [m]
constexpr double slack = 0.005;     ///< by which a circle is drawn back from a start or goal within it [m]

constexpr double boxCorner = 0.05;  ///< of way points at the corners of a closed rectangle from it [m]

bool isFree(const Vec2& a, const Vec2& b, const Obstacles& in) {
  if (in.closed && in.closed->meets(a, b)) return false;
  return std::ranges::none_of(in.circles, [&](const Obstacle& obstacle) {
    return distanceToSegment(obstacle.centre, a, b) < obstacle.radius;
  });
}

void keepRelevant(Obstacles& all, const Vec2& start, const Vec2& goal,
                  const PathPlannerParameters& parameters) {
  if (all.closed && (all.closed->contains(start) || all.closed->contains(goal))) all.closed.reset();
  std::vector<Obstacle>& obstacles = all.circles;
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

std::vector<Vec2> cornersOf(const Obstacles& all, double corner) {
  static const std::array<Vec2, cornersOfObstacle> directions = [] {
    std::array<Vec2, cornersOfObstacle> all;
    for (int i = 0; i < cornersOfObstacle; ++i) {
      const double angle = 2 * pi * i / cornersOfObstacle;
      all[static_cast<std::size_t>(i)] = Vec2(std::cos(angle), std::sin(angle));
    }
    return all;
  }();
  std::vector<Vec2> corners;
  const auto add = [&](const Vec2& p) {
    const bool inside = std::ranges::any_of(
        all.circles, [&](const Obstacle& other) { return (p - other.centre).norm() < other.radius; });
    if (!inside && !(all.closed && all.closed->contains(p))) corners.push_back(p);
  };
  for (const Obstacle& obstacle : all.circles)
    for (const Vec2& direction : directions) add(obstacle.centre + corner * obstacle.radius * direction);
  if (all.closed)
    for (const double x : {all.closed->low.x() - boxCorner, all.closed->high.x() + boxCorner})
      for (const double y : {all.closed->low.y() - boxCorner, all.closed->high.y() + boxCorner}) add({x, y});
  return corners;
}

/// The corners of a shortest path that ends at the goal; empty if there is none.
std::vector<Vec2> shortestPath(const Vec2& start, const Vec2& goal, const Obstacles& obstacles,
                               const Vec2& last, const PathPlannerParameters& parameters) {
  std::vector<Vec2> nodes = cornersOf(obstacles, parameters.corner);
  nodes.push_back(goal);
  const std::size_t count = nodes.size(), end = count - 1;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> cost(count, infinite);
  std::vector<std::size_t> before(count, count);  // count: the start
  std::vector<bool> done(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    if (!isFree(start, nodes[i], obstacles)) continue;
    const Vec2 way = nodes[i] - start;
    cost[i] = way.norm();
    if (!last.isZero() && cost[i] > 1e-6)
      cost[i] +=
          parameters.turnCost * std::acos(std::clamp(way.dot(last) / (cost[i] * last.norm()), -1.0, 1.0));
  }
  while (!done[end]) {
    std::size_t here = count;
    for (std::size_t i = 0; i < count; ++i)
      if (!done[i] && cost[i] < infinite && (here == count || cost[i] < cost[here])) here = i;
    if (here == count) return {};
    done[here] = true;
    for (std::size_t i = 0; i < count; ++i) {
      const double length = (nodes[i] - nodes[here]).norm();
      if (done[i] || cost[here] + length >= cost[i] || !isFree(nodes[here], nodes[i], obstacles)) continue;
      cost[i] = cost[here] + length;
      before[i] = here;
    }
  }
  std::vector<Vec2> path;
  for (std::size_t i = end; i < count; i = before[i]) path.push_back(nodes[i]);
  std::ranges::reverse(path);
  return path;
}

/// The obstacles with half of the distance that corners keep from them, so that who walks straight to a point
/// of the path keeps some, too; no circle holds start or goal.
Obstacles widened(Obstacles obstacles, const Vec2& start, const Vec2& goal, double corner) {
  for (Obstacle& obstacle : obstacles.circles) {
    obstacle.radius *= 0.5 * (1 + corner);
    for (const Vec2& end : {start, goal})
      obstacle.radius = std::min(obstacle.radius, (end - obstacle.centre).norm() - touch);
  }
  return obstacles;
}

/// The farthest point of a path within `lookAhead` to which the straight way is free; at least the path's
/// first corner.
Vec2 farthestInSight(const Vec2& start, const std::vector<Vec2>& path, const Obstacles& obstacles,
                     double lookAhead) {
  Vec2 best = path.front(), from = best;
  double left = lookAhead - (best - start).norm();
  for (std::size_t i = 1; i < path.size() && left > 0; ++i) {
    const Vec2 way = path[i] - from;
    const double length = way.norm();
    const int steps = static_cast<int>(std::min(left, length) / sightStep);
    for (int step = 1; step <= steps; ++step) {
      const Vec2 point = from + step * sightStep / length * way;
      if (!isFree(start, point, obstacles)) return best;
      best = point;
    }
    from = path[i];
    left -= length;
  }
  return best;
}

}  // namespace

double distanceToSegment(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const double length = way.squaredNorm();
  const double share = length > 1e-12 ? std::clamp((point - a).dot(way) / length, 0.0, 1.0) : 0;
  return (a + share * way - point).norm();
}

std::vector<Vec2> shortestWay(const Vec2& start, const Vec2& goal, const Obstacles& obstacles,
                              const Vec2& last, const PathPlannerParameters& parameters) {
  Obstacles relevant = obstacles;
  keepRelevant(relevant, start, goal, parameters);
  std::vector<Vec2> path;
  if (!isFree(start, goal, relevant)) path = shortestPath(start, goal, relevant, last, parameters);
  if (path.empty()) path.push_back(goal);
  return path;
}

Vec2 nextWayPoint(const Vec2& start, const Vec2& goal, const Obstacles& obstacles, const Vec2& last,
                  const PathPlannerParameters& parameters) {
  const std::vector<Vec2> path = shortestWay(start, goal, obstacles, last, parameters);
  if (path.size() == 1) return goal;
  return farthestInSight(start, path, widened(obstacles, start, goal, parameters.corner),
                         parameters.lookAhead);
}

}  // namespace plumbline
