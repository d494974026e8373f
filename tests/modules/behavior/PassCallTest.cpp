#include "modules/behavior/PassCall.h"

#include <gtest/gtest.h>

#include "situation/kinds/PassCallSituationKind.h"
#include "support/DrawnBy.h"
#include "support/ModuleHarness.h"
#include "support/SituationHarness.h"

using namespace plumbline;

namespace {

/// A striker at the ball in the middle of the field, an opponent on its way there.
struct PassCallTest : testing::Test {
  PassCallTest() {
    harness.input<GameState>().playMode = TeamPlayMode::playOn;
    PlayerRole& role = harness.input<PlayerRole>();
    role.role = PlayerRole::striker;
    role.members = 4;
    harness.input<FieldDimensions>();
    harness.input<RobotPose>().valid = true;
    BallPos& ball = harness.input<BallPos>();
    ball.valid = true;
    ball.field = {0, 0};
    ball.relative = {0.3, 0};
    OtherRobot& opponent = harness.input<OtherRobots>().robots.emplace_back();
    opponent.position = {1.5, 0};
  }
  bool asks() {
    harness.cycle();
    return harness.output<PassRequest>().active;
  }
  test::ModuleHarness<PassCall> harness;
};

TEST_F(PassCallTest, asksWhereAnOpponentComes) {
  EXPECT_TRUE(asks());
  harness.input<OtherRobots>().robots[0].position = {6, 0};
  EXPECT_FALSE(asks()) << "there is time enough";
  harness.input<OtherRobots>().robots.clear();
  EXPECT_FALSE(asks());
}

TEST_F(PassCallTest, asksOnlyAtTheBallAndInPlay) {
  harness.input<BallPos>().relative = {0.7, 0};
  EXPECT_FALSE(asks());
  harness.input<BallPos>().relative = {0.3, 0};
  EXPECT_TRUE(asks());
  harness.input<GameState>().playMode = TeamPlayMode::passOwn;
  EXPECT_FALSE(asks());
  harness.input<GameState>().playMode = TeamPlayMode::kickInOwn;
  EXPECT_FALSE(asks());
}

TEST_F(PassCallTest, theStrikerAsksAndNobodyElse) {
  harness.input<PlayerRole>().role = PlayerRole::supporter;
  EXPECT_FALSE(asks());
  harness.input<PlayerRole>().role = PlayerRole::striker;
  harness.input<PlayerRole>().mayTouchBall = false;
  EXPECT_FALSE(asks());
  harness.input<PlayerRole>().mayTouchBall = true;
  harness.input<PlayerRole>().members = 1;
  EXPECT_FALSE(asks()) << "without a mate a goal would not count";
}

TEST_F(PassCallTest, notWhereItShootsItself) {
  harness.input<BallPos>().field = {8, 0};
  harness.input<OtherRobots>().robots[0].position = {9.5, 0};
  EXPECT_FALSE(asks());
}

TEST_F(PassCallTest, theRequestIsDrawnAtTheBall) {
  const Drawing asked = test::drawnBy("draw:team:pass", [&] { asks(); });
  EXPECT_EQ(test::placeOf(asked, "pass mode?"), Vec3(0, 0, 0));
  harness.input<OtherRobots>().robots.clear();
  EXPECT_TRUE(test::drawnBy("draw:team:pass", [&] { asks(); }).shapes().empty());
}

/// A file with positions and whether people expect a request (tests/data/situations/passCall).
struct PassSituations : PassCallTest, testing::WithParamInterface<std::string> {};

TEST_P(PassSituations, areDecidedAsExpected) {
  const test::WrittenSituation<CallExpected> written("passCall", GetParam());
  test::placeScene(harness, *written);
  EXPECT_EQ(asks(), written.expected().asks);
}

INSTANTIATE_TEST_SUITE_P(Written, PassSituations, testing::ValuesIn(test::situationNames("passCall")),
                         test::situationName);

}  // namespace
