#include "modules/behavior/Supporter.h"

#include <gtest/gtest.h>

#include "support/ModuleHarness.h"
#include "support/Situation.h"

using namespace plumbline;

namespace {

struct SupporterTest : testing::Test {
  SupporterTest() {
    harness.input<GameState>().playMode = PlayMode::playOn;
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
struct SupporterSituations : SupporterTest, testing::WithParamInterface<const char*> {};

TEST_P(SupporterSituations, areDecidedAsExpected) {
  const ConfigFile file = test::situationFile(std::string("supporter/") + GetParam());
  const ConfigSection& root = file.root();
  const Pose2 robot = test::poseOf(root, "robot");
  harness.input<PlayerRole>().place = test::poseOf(root, "place");
  test::placeBall(harness.input<BallPos>(), robot, root.get<Vec2>("ball"));
  harness.input<BallPos>().age = root.find<double>("ballAge").value_or(0);
  const BehaviorOutput& output = at(robot);
  const ConfigSection expected = root.section("expected");
  ASSERT_EQ(output.skill, expected.get<std::string>("skill"));
  if (!expected.has("target")) return;
  const Pose2 target = test::poseOf(expected, "target");
  EXPECT_LT((output.target.position - target.position).norm(), expected.get<double>("within"));
  EXPECT_NEAR(normalizeAngle(output.target.heading - target.heading), 0, expected.get<double>("within"));
}

INSTANTIATE_TEST_SUITE_P(Written, SupporterSituations,
                         testing::Values("atItsPlace", "ballBehindIt", "ballThatNobodySees",
                                         "farFromItsPlace"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
