#include "tactics/approach/BallPath.h"

#include <gtest/gtest.h>

#include "math/Angle.h"

using namespace plumbline;

namespace {

const BallApproachParameters p{.avoidRadius = 0.26, .stepAngle = 0.25, .behindAngle = 0.53};
const Vec2 ball(0.2, 0.05);

struct Followed {
  double length = 0, closest = 1e9;
  bool arrived = false;
};

// Follows the way points in steps of a centimetre.
Followed follow(Vec2 position, Around side) {
  Followed way;
  for (int i = 0; i < 1000 && !way.arrived; ++i) {
    const Vec2 rest = pathToPlace(position, ball, side, p).next - position;
    const Vec2 step = rest.norm() > 0.01 ? Vec2(0.01 * rest.normalized()) : rest;
    position += step;
    way.length += step.norm();
    way.closest = std::min(way.closest, (position - ball).norm());
    way.arrived = position.norm() < 1e-6;
  }
  return way;
}

TEST(BallPath, behindTheBallTheWayIsStraight) {
  const BallPath path = pathToPlace({-1, 0.1}, ball, Around::clockwise, p);
  EXPECT_TRUE(path.last);
  EXPECT_EQ(path.next, Vec2(0, 0));
  EXPECT_NEAR(path.length, std::hypot(1, 0.1), 1e-12);
}

TEST(BallPath, fromEverySideAndOnEitherSideItComesToThePlaceAndKeepsOffTheBall) {
  for (int degrees = 0; degrees < 360; degrees += 15)
    for (const Around side : {Around::clockwise, Around::counterclockwise}) {
      const Vec2 from = ball + 1.5 * Vec2(std::cos(fromDegrees(degrees)), std::sin(fromDegrees(degrees)));
      const Followed way = follow(from, side);
      EXPECT_TRUE(way.arrived) << degrees;
      EXPECT_GT(way.closest, 0.19) << degrees;
      EXPECT_NEAR(pathToPlace(from, ball, side, p).length, way.length, 0.12) << degrees;
    }
}

TEST(BallPath, theSideDecidesWhereItGoesRound) {
  const Vec2 before(1.2, 0.05);
  EXPECT_GT(pathToPlace(before, ball, Around::counterclockwise, p).next.y(), 0.2);
  EXPECT_LT(pathToPlace(before, ball, Around::clockwise, p).next.y(), -0.1);
}

TEST(BallPath, aRobotThatTouchesTheCircleGoesOutOfIt) {
  const Vec2 near = ball + Vec2(0.12, 0);
  const BallPath path = pathToPlace(near, ball, Around::clockwise, p);
  EXPECT_FALSE(path.last);
  EXPECT_GT((path.next - ball).norm(), p.avoidRadius);
}

}  // namespace
