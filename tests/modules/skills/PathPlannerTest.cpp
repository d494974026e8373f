#include "modules/skills/path/PathPlanner.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/Angle.h"
#include "math/Random.h"

using namespace plumbline;

namespace {

/// Walks from way point to way point; the length of the way, and how near it came to the obstacles at least,
/// as a share of their radius.
std::pair<double, double> walk(const Vec2& start, const Vec2& goal, const std::vector<Obstacle>& obstacles) {
  Vec2 here = start, last = Vec2::Zero();
  double length = 0, nearest = 1e9;
  for (int i = 0; i < 2000 && (here - goal).norm() > 0.02; ++i) {
    const Vec2 way = nextWayPoint(here, goal, obstacles, last, {}) - here;
    last = way.normalized();
    here += std::min(0.02, way.norm()) * last;
    length += 0.02;
    for (const Obstacle& obstacle : obstacles)
      nearest = std::min(nearest, (here - obstacle.centre).norm() / obstacle.radius);
  }
  EXPECT_LT((here - goal).norm(), 0.03);
  return {length, nearest};
}

TEST(PathPlannerTest, goesStraightWhereNothingIsInTheWay) {
  EXPECT_EQ(nextWayPoint({0, 0}, {5, 0}, {}, Vec2::Zero(), {}), Vec2(5, 0));
  EXPECT_EQ(nextWayPoint({0, 0}, {5, 0}, {{{2, 1}, 0.5}}, Vec2::Zero(), {}), Vec2(5, 0));
}

TEST(PathPlannerTest, goesRoundOneAndLittleFarther) {
  const auto [length, nearest] = walk({0, 0}, {5, 0}, {{{2.5, 0.1}, 0.5}});
  EXPECT_LT(length, 5.4);
  EXPECT_GT(nearest, 0.97);
}

TEST(PathPlannerTest, findsTheGapInAWall) {
  std::vector<Obstacle> wall;
  for (const double y : {-1.6, -0.8, 0.0, 0.8, 2.4}) wall.push_back({{2.5, y}, 0.5});
  const auto [length, nearest] = walk({0, 0}, {5, 0}, wall);
  EXPECT_LT(length, 6.2);
  EXPECT_GT(nearest, 0.97);
}

TEST(PathPlannerTest, leavesACircleItStandsInAndReachesAGoalWithinOne) {
  const auto [length, nearest] = walk({0, 0}, {4, 0}, {{{0.2, 0}, 0.5}, {{4.2, 0}, 0.5}});
  EXPECT_LT(length, 5.2);
  EXPECT_GT(nearest, 0.2);
}

TEST(PathPlannerTest, goesRoundAClosedRectangle) {
  Obstacles obstacles{{{2, -1.2}, 0.5}};
  obstacles.closed = Box2{{1, -1}, {3, 4}};
  const std::vector<Vec2> way = shortestWay({0, 0}, {5, 0}, obstacles, Vec2::Zero(), {});
  Vec2 from(0, 0);
  for (const Vec2& corner : way) {
    EXPECT_FALSE(obstacles.closed->meets(from, corner));
    EXPECT_GE(distanceToSegment({2, -1.2}, from, corner), 0.5);
    from = corner;
  }
  EXPECT_GE(way.size(), 3u);
  EXPECT_EQ(nextWayPoint({2, 1}, {5, 0}, obstacles, Vec2::Zero(), {}), Vec2(5, 0)) << "out of it";
}

TEST(PathPlannerTest, withoutAnyWayItGoesStraight) {
  std::vector<Obstacle> ring;
  for (int i = 0; i < 6; ++i) ring.push_back({{std::cos(i * pi / 3), std::sin(i * pi / 3)}, 0.6});
  EXPECT_EQ(nextWayPoint({0, 0}, {3, 0}, ring, Vec2::Zero(), {}), Vec2(3, 0));
}

TEST(PathPlannerTest, amongManyItNeverRunsIntoOneThatItLooksAt) {
  Random random(11);
  for (int run = 0; run < 40; ++run) {
    std::vector<Obstacle> obstacles;
    for (int i = 0; i < 5; ++i) obstacles.push_back({{random.uniform(1, 9), random.uniform(-2, 2)}, 0.5});
    const auto [length, nearest] = walk({0, 0}, {10, 0}, obstacles);
    EXPECT_GT(nearest, 0.95) << run;
    EXPECT_LT(length, 13) << run;
  }
}

TEST(PathPlannerTest, inACrowdFewWayPointsLieAtTheRobotsFeet) {
  Random random(5);
  int detours = 0, near = 0;
  for (int run = 0; run < 4000; ++run) {
    std::vector<Obstacle> crowd;
    for (int i = 0; i < 3; ++i) crowd.push_back({{random.uniform(-0.7, 1.5), random.uniform(-1, 1)}, 0.42});
    if (std::ranges::any_of(crowd, [](const Obstacle& other) { return other.centre.norm() < 0.25; }))
      continue;
    const Vec2 goal(random.uniform(1.5, 3), random.uniform(-0.5, 0.5));
    const Vec2 wayPoint = nextWayPoint({0, 0}, goal, crowd, Vec2::Zero(), {});
    if (wayPoint == goal) continue;
    ++detours;
    if (wayPoint.norm() < 0.2) ++near;
  }
  EXPECT_GT(detours, 1500);
  EXPECT_LT(near, 0.08 * detours);
}

TEST(PathPlannerTest, theSameSituationGivesTheSameWay) {
  const std::vector<Obstacle> obstacles = {{{2, 0}, 0.5}, {{3, 0.4}, 0.5}};
  const Vec2 first = nextWayPoint({0, 0}, {5, 0}, obstacles, Vec2::Zero(), {});
  EXPECT_EQ(nextWayPoint({0, 0}, {5, 0}, obstacles, Vec2::Zero(), {}), first);
}

TEST(DistanceToSegmentTest, isMeasuredToItsEndsToo) {
  EXPECT_DOUBLE_EQ(distanceToSegment({1, 1}, {0, 0}, {2, 0}), 1);
  EXPECT_DOUBLE_EQ(distanceToSegment({-1, 0}, {0, 0}, {2, 0}), 1);
  EXPECT_DOUBLE_EQ(distanceToSegment({3, 4}, {0, 0}, {0, 0}), 5);
}

TEST(PathPlannerTest, theWholeWayEndsAtTheGoalAndKeepsClearOfTheObstacles) {
  const std::vector<Obstacle> wall{{{2.5, 0}, 0.5}, {{2.5, 0.8}, 0.5}};
  EXPECT_EQ(shortestWay({0, 0}, {5, 0}, {}, Vec2::Zero(), {}), std::vector<Vec2>{Vec2(5, 0)});
  const std::vector<Vec2> way = shortestWay({0, 0}, {5, 0}, wall, Vec2::Zero(), {});
  ASSERT_GT(way.size(), 1u);
  EXPECT_EQ(way.back(), Vec2(5, 0));
  Vec2 from(0, 0);
  for (const Vec2& corner : way) {
    for (const Obstacle& obstacle : wall)
      EXPECT_GE(distanceToSegment(obstacle.centre, from, corner), obstacle.radius - 1e-9);
    from = corner;
  }
}

}  // namespace
