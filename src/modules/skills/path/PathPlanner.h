#pragma once
#include <initializer_list>
#include <optional>
#include <vector>

#include "math/Box2.h"
#include "math/Types.h"
#include "parameters/Parameter.h"

namespace plumbline {

/// What must not be walked into: a circle on the ground [m].
struct Obstacle {
  Vec2 centre = Vec2::Zero();
  double radius = 0.5;
};

/// All of them, and a rectangle that no way may lead through. Who is in it, or goes into it, may.
struct Obstacles {
  Obstacles() = default;
  Obstacles(std::vector<Obstacle> those) : circles(std::move(those)) {}
  Obstacles(std::initializer_list<Obstacle> those) : circles(those) {}
  std::vector<Obstacle> circles;
  std::optional<Box2> closed;
};

struct PathPlannerParameters {
  PARAMETERS(PathPlannerParameters)
  PARAMETER(int, maxObstacles, 6, "", Range(1, 30), "the nearest ones to the way that are looked at")
  PARAMETER(double, corridor, 2, "m", Range(0.1, 30), "farther from the straight way an obstacle is left out")
  PARAMETER(double, corner, 1.3, "", Range(1.09, 3), "way points around an obstacle, share of its radius")
  PARAMETER(double, turnCost, 0.25, "m/rad", Range(0, 5),
            "length that is added to a path that starts in another direction than the last one")
  PARAMETER(
      double, lookAhead, 0.5, "m", Range(0, 5),
      "the way point lies so far along the path if the robot can go straight there, because towards one "
      "at its feet it turns on the spot")
};

/// The next way point of a shortest way from start to goal around the obstacles: a search over eight points
/// around each obstacle and the straight lines between them (a visibility graph with Dijkstra's algorithm).
/// Unlike a random tree it is the same every time, near to the shortest, and done in some ten microseconds.
/// Of a circle that holds start or goal only the part that does not counts. The way point is the first corner
/// or the farthest point of the path within `lookAhead` that can be reached straight. last: direction of the
/// last way, zero if there was none. The goal itself if the straight way is free, or if there is none at all.
Vec2 nextWayPoint(const Vec2& start, const Vec2& goal, const Obstacles& obstacles, const Vec2& last,
                  const PathPlannerParameters& parameters);

/// The corners of that whole way, the goal last; only the goal if the straight way is free or there is none.
std::vector<Vec2> shortestWay(const Vec2& start, const Vec2& goal, const Obstacles& obstacles,
                              const Vec2& last, const PathPlannerParameters& parameters);

/// Distance of a point and the segment from a to b [m].
double distanceToSegment(const Vec2& point, const Vec2& a, const Vec2& b);

}  // namespace plumbline
