#include "modules/behavior/Striker2.h"

#include <gtest/gtest.h>

#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

struct Striker2Test : testing::Test {
  Striker2Test() {
    harness.input<GameState>().playMode = TeamPlayMode::playOn;
    harness.input<RobotPose>().valid = true;
    harness.input<RobotPose>().pose = Pose2(-1, 0, 0);
    BallPos& ball = harness.input<BallPos>();
    ball.valid = true;
    ball.age = 0;
    ball.field = {0, 0};
    harness.input<FieldDimensions>();
    harness.input<SkillKickParameters>();
  }
  const BehaviorOutput& decide() {
    harness.cycle();
    return harness.output<StrikerOutput>();
  }
  test::ModuleHarness<Striker2> harness;
};

TEST_F(Striker2Test, kicksTowardsTheGoalAsFarAsTheKickCarries) {
  EXPECT_EQ(decide().skill, Skill::kick);
  EXPECT_TRUE(decide().active);
  EXPECT_NEAR(decide().target.x(), 3 - 0.4, 0.05) << "a little less, so that no longer kick is taken";
  EXPECT_NEAR(decide().target.y(), 0, 0.2);
}

TEST_F(Striker2Test, saysHowExactlyAKickHasToGo) {
  const double anywhere = decide().tolerance;
  EXPECT_LE(anywhere, 0.35);
  // 6 m before the goal with a kick that reaches it.
  Kick& kick = harness.input<SkillKickParameters>().kicks[0];
  kick.distance = 9;
  kick.scatter = 0.05;
  harness.input<BallPos>().field = {9, 0};
  harness.input<RobotPose>().pose = Pose2(8.5, 0, 0);
  EXPECT_EQ(decide().skill, Skill::kick);
  EXPECT_LT(decide().tolerance, anywhere);
  EXPECT_GE(decide().tolerance, 0.12);
}

TEST_F(Striker2Test, onlyDribblesIfSet) {
  harness.module().kickAllowed = false;
  EXPECT_EQ(decide().skill, Skill::dribble);
  EXPECT_EQ(decide().tolerance, 0);
}

TEST_F(Striker2Test, dribblesOverTheLine) {
  harness.input<BallPos>().field = {14.5, 0.2};
  EXPECT_EQ(decide().skill, Skill::dribble);
}

TEST_F(Striker2Test, turnsToSearchALostBallOrItself) {
  harness.input<BallPos>().age = 3.1;
  EXPECT_EQ(decide().skill, Skill::moveToPos);
  EXPECT_EQ(decide().target.x(), -1);
  EXPECT_NEAR(decide().target.heading, 1, 1e-12);
  harness.input<BallPos>().age = 0;
  harness.input<RobotPose>().valid = false;
  EXPECT_EQ(decide().skill, Skill::moveToPos);
}

TEST_F(Striker2Test, keepsItsDistanceAtTheOpponentsRestart) {
  harness.input<GameState>().playMode = TeamPlayMode::kickInOpponent;
  harness.input<BallPos>().field = {5, 10};
  const BehaviorOutput& output = decide();
  EXPECT_EQ(output.skill, Skill::moveToPos);
  EXPECT_NEAR((output.target.position - Vec2(5, 10)).norm(), 2.2, 1e-12);
  // On the way to the own goal, facing the ball.
  EXPECT_LT(output.target.x(), 5);
  const Vec2 toBall = Vec2(5, 10) - output.target.position;
  EXPECT_NEAR(output.target.heading, std::atan2(toBall.y(), toBall.x()), 1e-12);
}

TEST_F(Striker2Test, standsWhenTheGameIsOver) {
  harness.input<GameState>().playMode = TeamPlayMode::gameOver;
  EXPECT_EQ(decide().skill, Skill::stand);
}

TEST_F(Striker2Test, saysWhatItDecidedAndWhatAgainst) {
  auto& kicks = harness.input<SkillKickParameters>().kicks;
  kicks[0].motion = "kickShort";
  for (int i = 1; i <= 5; ++i) {
    kicks.push_back(kicks[0]);
    kicks.back().motion = "kick" + std::to_string(i);
    kicks.back().distance = 3 + i;
  }
  const BehaviorOutput& output = decide();
  const StrikerDecision& decision = harness.output<StrikerDecision>();
  EXPECT_TRUE(decision.valid);
  EXPECT_EQ(decision.ball, Vec2(0, 0));
  ASSERT_EQ(decision.options.size(), StrikerDecision::maxOptions) << "of seven that were compared";
  const Vec2 way = decision.options[0].end.normalized();
  EXPECT_NEAR(way.dot(output.target.position.normalized()), 1, 1e-9) << "what it does stands first";
  for (std::size_t i = 1; i < decision.options.size(); ++i) {
    EXPECT_LE(decision.options[i].value, decision.options[i - 1].value);
    EXPECT_NE(decision.options[i].action, decision.options[0].action);
    EXPECT_GE(decision.options[i].goal, 0);
    EXPECT_LE(decision.options[i].goal, 1);
  }
  harness.input<GameState>().playMode = TeamPlayMode::kickInOpponent;
  decide();
  EXPECT_FALSE(decision.valid);
  EXPECT_TRUE(decision.options.empty());
}

}  // namespace
