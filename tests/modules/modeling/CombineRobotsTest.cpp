#include "modules/modeling/others/CombineRobots.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

OtherRobot robotAt(const Vec2& position, double deviation, double lastSeen, int number = 4) {
  OtherRobot robot;
  robot.number = number;
  robot.position = position;
  robot.covariance = deviation * deviation * Mat2::Identity();
  robot.lastSeen = lastSeen;
  return robot;
}

TEST(CombineRobotsTest, whatIsSeenNowIsTakenAsItIsSeen) {
  const auto all = combineRobots({robotAt({1, 1}, 0.1, 10)}, {robotAt({1.2, 1}, 0.1, 10)}, 10.1, 0.3);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].position, Vec2(1, 1));
}

TEST(CombineRobotsTest, weighsByCovarianceWhatWasSeenBefore) {
  const auto all = combineRobots({robotAt({1, 1}, 0.2, 9)}, {robotAt({1.3, 1}, 0.1, 10)}, 10.1, 0.3);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].position.x(), (1 / 0.04 + 1.3 / 0.01) / (1 / 0.04 + 1 / 0.01), 1e-9);
  EXPECT_LT(all[0].deviation(), 0.1);
  EXPECT_EQ(all[0].lastSeen, 10);
}

TEST(CombineRobotsTest, theYoungerCountsWhereTheyDisagree) {
  const auto all = combineRobots({robotAt({1, 1}, 0.2, 9)}, {robotAt({5, 1}, 0.1, 10)}, 10.1, 0.3);
  EXPECT_EQ(all[0].position, Vec2(5, 1));
  const auto other = combineRobots({robotAt({1, 1}, 0.2, 9.5)}, {robotAt({5, 1}, 0.1, 9)}, 10.1, 0.3);
  EXPECT_EQ(other[0].position, Vec2(1, 1));
}

TEST(CombineRobotsTest, whomOnlyMatesSeeIsAdded) {
  const auto all = combineRobots({robotAt({1, 1}, 0.2, 9)}, {robotAt({5, 1}, 0.1, 10, 5)}, 10.1, 0.3);
  EXPECT_EQ(all.size(), 2u);
}

}  // namespace
