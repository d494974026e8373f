#include "modules/behavior/Striker2.h"

#include <gtest/gtest.h>

#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

struct Striker2Test : testing::Test {
  Striker2Test() {
    harness.input<GameState>().playMode = PlayMode::playOn;
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

TEST_F(Striker2Test, kicksAtTheGoalFromAfar) {
  EXPECT_EQ(decide().skill, Skill::kick);
  EXPECT_TRUE(decide().active);
  EXPECT_NEAR(decide().target.x(), 15, 1e-9);
  EXPECT_NEAR(decide().target.y(), 0, 1e-9);
}

TEST_F(Striker2Test, splitsTheAngleBetweenThePosts) {
  // 1.8 m before the line and 3 m to the left: posts, less 15 cm, at -atan(2.1 / 1.8) and -atan(3.9 / 1.8).
  harness.input<BallPos>().field = {13.2, 3};
  const Vec2 line = decide().target.position - Vec2(13.2, 3);
  EXPECT_NEAR(std::atan2(line.y(), line.x()), -(std::atan(2.1 / 1.8) + std::atan(3.9 / 1.8)) / 2, 1e-9);
  EXPECT_EQ(decide().skill, Skill::dribble);  // too narrow for a kick
}

TEST_F(Striker2Test, theLineHitsTheGoalFromEverywhere) {
  for (double x = -14; x < 14.6; x += 0.7)
    for (double y = -9.5; y < 9.6; y += 0.5) {
      harness.input<BallPos>().field = {x, y};
      const Vec2 line = decide().target.position - Vec2(x, y);
      EXPECT_LT(std::abs(y + line.y() / line.x() * (15 - x)), 1.05) << x << " " << y;
    }
}

TEST_F(Striker2Test, bringsTheBallNearerWithAShorterKickWhereTheGoalIsNarrow) {
  std::vector<Kick>& kicks = harness.input<SkillKickParameters>().kicks;
  kicks.resize(2);
  kicks[0].distance = 3;
  kicks[1].distance = 10;
  // 9 m before the goal, half the angle between the posts, less 15 cm, is 0.1 rad.
  harness.input<BallPos>().field = {6, 0};
  EXPECT_EQ(decide().skill, Skill::kick);
  EXPECT_NEAR(decide().target.x(), 9, 1e-9);
  // 5 m before it is 0.18 rad: the goal itself; 20 m before it nothing reaches it.
  harness.input<BallPos>().field = {10, 0};
  EXPECT_NEAR(decide().target.x(), 15, 1e-9);
  harness.input<BallPos>().field = {-5, 0};
  EXPECT_NEAR(decide().target.x(), 15, 1e-9);
  // 3.5 m away at an angle no kick leaves the ball on the field.
  harness.input<BallPos>().field = {14, 3.3};
  EXPECT_EQ(decide().skill, Skill::dribble);
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
  harness.input<GameState>().playMode = PlayMode::kickInOpponent;
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
  harness.input<GameState>().playMode = PlayMode::gameOver;
  EXPECT_EQ(decide().skill, Skill::stand);
}

}  // namespace
