#include "modules/modeling/ball/TeamBall.h"

#include <gtest/gtest.h>

#include "tactics/RollingBall.h"

using namespace plumbline;

namespace {

TEST(TeamBallTest, rollsOnAndComesToRest) {
  EXPECT_EQ(rolledOn({1, 2}, {0, 0}, 3), Vec2(1, 2));
  EXPECT_NEAR(rolledOn({0, 0}, {2, 0}, 100).x(), 1.84, 1e-3);
  EXPECT_EQ(rolledOn({1, 2}, {1, 1}, -1), Vec2(1, 2));
}

TEST(TeamBallTest, weighsByCertainty) {
  const auto ball = combineBalls({{{0, 0}, {0, 0}, 0.1, 0.2}, {{0.3, 0}, {0, 0}, 0.2, 0.1}});
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->position.x(), 0.06, 1e-9);
  EXPECT_LT(ball->deviation, 0.1);
  EXPECT_EQ(ball->age, 0.1);
}

TEST(TeamBallTest, leavesOutABallThatWasElsewhere) {
  const auto ball =
      combineBalls({{{0, 0}, {0, 0}, 0.1, 0}, {{5, 0}, {0, 0}, 0.2, 2}, {{0.1, 0}, {0, 0}, 0.1, 0}});
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->position.x(), 0.05, 1e-9);
}

TEST(TeamBallTest, nobodyKnowsOne) { EXPECT_FALSE(combineBalls({})); }

}  // namespace
