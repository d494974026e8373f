#include "modules/behavior/BlockOpponent.h"

#include <gtest/gtest.h>

#include "support/ModuleHarness.h"
#include "support/Robots.h"

using namespace plumbline;

namespace {

struct BlockOpponentTest : testing::Test {
  BlockOpponentTest() {
    harness.input<FieldDimensions>();
    harness.input<BallPos>().valid = true;
    harness.input<BallPos>().field = {-5, 4};
    harness.input<OtherRobots>();
  }
  OtherRobot& add(bool mate, int number, const Vec2& place) {
    return test::addRobot(harness.input<OtherRobots>().robots, mate, place, number);
  }
  const BlockPosition& output() {
    harness.cycle();
    return harness.output<BlockPosition>();
  }
  test::ModuleHarness<BlockOpponent> harness;
};

TEST_F(BlockOpponentTest, standsBeforeTheOneNearestToTheOwnGoal) {
  add(false, 9, {-9, -2});
  add(false, 8, {-4, -2});
  add(false, 7, {-5.2, 4});  // at the ball: the striker's
  add(true, 3, {-11, 0});
  const BlockPosition& block = output();
  ASSERT_TRUE(block.valid);
  EXPECT_EQ(block.opponent, 9);
  const Vec2 way = block.position - Vec2(-9, -2);
  EXPECT_NEAR(way.norm(), 0.9, 1e-9);
  const Vec2 toBall = Vec2(4, 6).normalized(), toGoal = Vec2(-6, 2).normalized();
  EXPECT_NEAR(way.dot(toBall), way.dot(toGoal), 1e-9) << "half-way between its ways";
}

TEST_F(BlockOpponentTest, nobodyIsBlockedWhoIsFallenFarOrOutOfReachOfAPass) {
  add(false, 9, {-9, -2}).fallen = true;
  add(false, 8, {6, -2});
  add(false, 7, {-13, -9.5});
  EXPECT_FALSE(output().valid);
}

TEST_F(BlockOpponentTest, anOpponentBetweenBallAndGoalIsBlockedOnTheGoalsSide) {
  const Vec2 ball(-5, 0), opponent(-8, 0);
  harness.input<BallPos>().field = ball;
  add(false, 9, opponent);
  EXPECT_TRUE(output().position.isApprox(Vec2(-8.9, 0)));
}

TEST_F(BlockOpponentTest, withoutABallThereIsNobodyToBlock) {
  add(false, 9, {-9, -2});
  harness.input<BallPos>().valid = false;
  EXPECT_FALSE(output().valid);
}

}  // namespace
