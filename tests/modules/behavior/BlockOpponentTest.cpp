#include "modules/behavior/BlockOpponent.h"

#include <gtest/gtest.h>

#include "situation/kinds/BlockSituationKind.h"
#include "support/ModuleHarness.h"
#include "support/Robots.h"
#include "support/SituationHarness.h"

using namespace plumbline;

namespace {

struct BlockOpponentTest : testing::Test {
  BlockOpponentTest() {
    harness.input<FieldDimensions>();
    harness.input<BallPos>().valid = true;
    harness.input<BallPos>().field = {-5, 4};
    harness.input<OtherRobots>();
    harness.input<OppInfo>();
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

TEST_F(BlockOpponentTest, opponentsThatKickFarPassFarther) {
  add(false, 9, {-10, -6});  // 11.2 m from the ball
  harness.input<OppInfo>().kickDistance = 4;
  EXPECT_FALSE(output().valid);
  harness.input<OppInfo>().kickDistance = 12;
  EXPECT_TRUE(output().valid);
  EXPECT_EQ(output().opponent, 9);
}

TEST_F(BlockOpponentTest, betweenWaysThatLeadApartItStandsNearerToTheOneToTheGoal) {
  harness.input<BallPos>().field = {-5, 0};
  add(false, 9, {-9, 0.5});
  const Vec2 toGoal = (Vec2(-15, 0) - Vec2(-9, 0.5)).normalized();
  EXPECT_GT((output().position - Vec2(-9, 0.5)).normalized().dot(toGoal), 0.95);
}

TEST_F(BlockOpponentTest, withoutABallThereIsNobodyToBlock) {
  add(false, 9, {-9, -2});
  harness.input<BallPos>().valid = false;
  EXPECT_FALSE(output().valid);
}

/// A file with positions and whom people expect to be blocked, from where (tests/data/situations/block).
struct BlockSituations : BlockOpponentTest, testing::WithParamInterface<std::string> {};

TEST_P(BlockSituations, areDecidedAsExpected) {
  const test::WrittenSituation<BlockExpected> written("block", GetParam());
  harness.input<BallPos>().field = written->ball;
  harness.input<OtherRobots>().robots = written->others;
  if (const auto& kick = knownTo<BlockKnowledge>(*written).kickDistance)
    harness.input<OppInfo>().kickDistance = *kick;
  const BlockPosition& block = output();
  const BlockExpected& expected = written.expected();
  ASSERT_EQ(block.valid ? block.opponent : 0, expected.opponent);
  if (expected.opponent == 0) return;
  EXPECT_LT((block.position - expected.place).norm(), expected.within)
      << "it is blocked at " << block.position.transpose();
}

INSTANTIATE_TEST_SUITE_P(Written, BlockSituations, testing::ValuesIn(test::situationNames("block")),
                         test::situationName);

}  // namespace
