#include "modules/behavior/Supporter.h"

#include <gtest/gtest.h>

#include "situation/kinds/SkillExpected.h"
#include "situation/kinds/SupporterSituationKind.h"
#include "support/ModuleHarness.h"
#include "support/SituationHarness.h"

using namespace plumbline;

namespace {

struct SupporterTest : testing::Test {
  SupporterTest() {
    harness.input<GameState>().playMode = TeamPlayMode::playOn;
    harness.input<RobotPose>().valid = true;
    PlayerRole& role = harness.input<PlayerRole>();
    role.role = PlayerRole::supporter + 2;
    role.members = 11;
    role.place = Pose2(3, 1, 0);
    harness.input<BallPos>().valid = true;
    harness.input<BallPos>().age = 0;
    harness.input<BallPos>().field = {6, 1};
  }
  const BehaviorOutput& at(const Pose2& pose) {
    harness.input<RobotPose>().pose = pose;
    harness.cycle();
    return harness.output<SupporterOutput>();
  }
  test::ModuleHarness<Supporter> harness;
};

TEST_F(SupporterTest, goesToItsPlaceAndStandsThere) {
  EXPECT_EQ(at(Pose2(0, 0, 0)).skill, Skill::moveToPos);
  EXPECT_EQ(at(Pose2(0, 0, 0)).target.position, Vec2(3, 1));
  EXPECT_EQ(at(Pose2(2.8, 1, 0)).skill, Skill::stand);
  EXPECT_EQ(at(Pose2(2.4, 1, 0)).skill, Skill::stand);  // not at every step of the ball
  EXPECT_EQ(at(Pose2(2.2, 1, 0)).skill, Skill::moveToPos);
}

TEST_F(SupporterTest, turnsToTheBallWhereItStands) {
  EXPECT_EQ(at(Pose2(3, 1, 1)).skill, Skill::moveToPos);
  EXPECT_EQ(at(Pose2(3, 1, 1)).target.position, Vec2(3, 1));
  EXPECT_NEAR(at(Pose2(3, 1, 1)).target.heading, 0, 1e-9);
}

TEST_F(SupporterTest, searchesABallThatNobodyHasSeen) {
  harness.input<BallPos>().age = 5;
  EXPECT_NEAR(at(Pose2(0, 0, 0)).target.heading, 1, 1e-9);
}

TEST_F(SupporterTest, leavesTheBallToTheStriker) {
  harness.input<PlayerRole>().role = PlayerRole::striker;
  EXPECT_FALSE(at(Pose2(0, 0, 0)).active);
  harness.input<PlayerRole>().mayTouchBall = false;
  EXPECT_TRUE(at(Pose2(0, 0, 0)).active);
  harness.input<PlayerRole>().role = PlayerRole::goalie;
  EXPECT_FALSE(at(Pose2(0, 0, 0)).active);
}

/// A file with positions and what people expect a supporter to do (tests/data/situations/supporter).
struct SupporterSituations : SupporterTest, testing::WithParamInterface<std::string> {};

TEST_P(SupporterSituations, areDecidedAsExpected) {
  const test::WrittenSituation<SkillExpected> written("supporter", GetParam());
  harness.input<PlayerRole>().place = *written->place;
  test::placeBall(harness.input<BallPos>(), written->robot, written->ball);
  harness.input<BallPos>().age = knownTo<SupporterKnowledge>(*written).ballAge;
  const BehaviorOutput& output = at(written->robot);
  const SkillExpected& expected = written.expected();
  ASSERT_EQ(output.skill, expected.skill);
  if (!expected.target) return;
  EXPECT_LT((output.target.position - *expected.target).norm(), expected.within);
  EXPECT_NEAR(normalizeAngle(output.target.heading - *expected.heading), 0, expected.within);
}

INSTANTIATE_TEST_SUITE_P(Written, SupporterSituations, testing::ValuesIn(test::situationNames("supporter")),
                         test::situationName);

}  // namespace
