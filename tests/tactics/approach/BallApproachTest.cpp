#include "tactics/approach/BallApproach.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

// Follows the way points with a point robot and returns its smallest distance to the ball.
double closestOnTheWay(Pose2 robot, const Vec2& ball, double heading, Pose2& end) {
  double closest = 1e9;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 relativeBall = robot.inverse() * ball;
    closest = std::min(closest, relativeBall.norm());
    const Pose2 way = approachBall(relativeBall, normalizeAngle(heading - robot.heading), {0.2, 0}, {});
    const Vec2 step = way.position.norm() > 0.01 ? Vec2(way.position.normalized() * 0.01) : way.position;
    robot = robot * Pose2(step, way.heading * 0.1);
  }
  end = robot;
  return closest;
}

TEST(BallApproach, goesStraightWhenBehindTheBall) {
  const Pose2 way = approachBall({1, 0}, 0, {0.2, 0.05}, {});
  EXPECT_NEAR(way.x(), 0.8, 1e-12);
  EXPECT_NEAR(way.y(), -0.05, 1e-12);
  EXPECT_EQ(way.heading, 0);
}

TEST(BallApproach, walksAroundTheBallFromEverySideAndArrives) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double angle = fromDegrees(degrees);
    Pose2 end;
    const Pose2 start(2 * std::cos(angle), 2 * std::sin(angle), 1.0);
    const double closest = closestOnTheWay(start, {0, 0}, 0.3, end);
    EXPECT_GT(closest, 0.195) << "from " << degrees << " degrees";
    EXPECT_NEAR((end * Vec2(0.2, 0)).norm(), 0, 0.01) << "from " << degrees << " degrees";
    EXPECT_NEAR(end.heading, 0.3, 0.01) << "from " << degrees << " degrees";
  }
}

TEST(BallApproach, startsOnTheShorterSide) {
  // The robot stands in front of the ball, a little to the left of the line: it goes round on the left.
  const Vec2 ball(-0.3, -0.05);
  EXPECT_GT(approachBall(ball, 0, {0.2, 0}, {}).y(), 0);
  EXPECT_LT(approachBall({-0.3, 0.05}, 0, {0.2, 0}, {}).y(), 0);
}

}  // namespace
