#include "RefereeFixture.h"

namespace plumbline::simulation {
namespace {

class PassMode : public test::RefereeTest {
protected:
  Man &passer = add(left, 7, -0.4, 0), &mate = add(left, 8, -4, 3), &opponent = add(right, 7, 1.2, 0);
  PassMode() { ball(0, 0); }
  void ask(int id = 1) { referee().askForPass(game, world, id); }
  bool granted() const { return game.mode == PlayMode::passLeft; }
};

TEST_F(PassMode, lastsFourSecondsAndKeepsOpponentsAway) {
  playOn();
  ask();
  ASSERT_TRUE(granted());
  put(opponent, 0.9, 0);
  cycle();
  EXPECT_LT((place(opponent) - Vec3(1.1, 0, standing)).norm(), 1e-9);
  pass(3.94);
  EXPECT_TRUE(granted());
  pass(0.04);
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(PassMode, endsWhenTheBallIsTouched) {
  playOn();
  ask();
  pass(1);
  EXPECT_TRUE(granted());
  cycle(&passer);
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(PassMode, ofTheRightTeam) {
  put(opponent, 0.4, 0);
  put(passer, -1.2, 0);
  playOn();
  ask(3);
  EXPECT_EQ(game.mode, PlayMode::passRight);
}

TEST_F(PassMode, isForPlayOnOnly) {
  game.setMode(PlayMode::kickInLeft);
  cycle();
  ask();
  EXPECT_FALSE(granted());
}

TEST_F(PassMode, needsABallAtRest) {
  playOn();
  world.ballState.linearVelocity = Vec3(0.06, 0, 0);
  cycle();
  ask();
  EXPECT_FALSE(granted());
  world.ballState.linearVelocity = Vec3(0.04, 0, 0);
  cycle();
  ask();
  EXPECT_TRUE(granted());
}

TEST_F(PassMode, needsThePlayerNearTheBall) {
  put(passer, -0.51, 0);
  playOn();
  ask();
  EXPECT_FALSE(granted());
  put(passer, -0.49, 0);
  cycle();
  ask();
  EXPECT_TRUE(granted());
}

TEST_F(PassMode, needsOpponentsAway) {
  put(opponent, 0.99, 0);
  playOn();
  ask();
  EXPECT_FALSE(granted());
}

TEST_F(PassMode, isNotGrantedAtTheBall) {
  playOn(&passer);
  ask();
  EXPECT_FALSE(granted());
  cycle();
  ask();
  EXPECT_TRUE(granted());
}

TEST_F(PassMode, notAgainForThreeSeconds) {
  playOn();
  ask();
  cycle();
  cycle(&passer);
  pass(2.9);
  ask();
  EXPECT_FALSE(granted());
  pass(0.12);
  ask();
  EXPECT_TRUE(granted());
}

TEST_F(PassMode, isNotGrantedIfTheRuleIsOff) {
  rules.pass.on = false;
  playOn();
  ask();
  EXPECT_FALSE(granted());
}

class PassGoal : public PassMode {
protected:
  void passTo(double x) {
    playOn();
    ask();
    cycle();
    cycle(&passer);
    ASSERT_EQ(game.mode, PlayMode::playOn);
    ball(x, 0);
    cycle();
  }
  void shoot() {
    ball(14.9, 0);
    cycle();
    ball(15.1, 0);
    cycle();
  }
};

TEST_F(PassGoal, tooSoonIsAGoalKick) {
  passTo(3);
  EXPECT_NEAR(game.passScoreWait[0], 10, 0.05);
  EXPECT_EQ(game.passScoreWait[1], 0);
  pass(9.9);
  shoot();
  EXPECT_EQ(game.mode, PlayMode::goalKickRight);
  EXPECT_EQ(game.score[0], 0);
}

TEST_F(PassGoal, countsAfterTenSeconds) {
  passTo(3);
  pass(10);
  shoot();
  EXPECT_EQ(game.score[0], 1);
}

TEST_F(PassGoal, countsWhenAMateTouchedTheBallOutsideTheCircle) {
  passTo(1.01);
  cycle(&mate);
  EXPECT_EQ(game.passScoreWait[0], 0);
  shoot();
  EXPECT_EQ(game.score[0], 1);
}

TEST_F(PassGoal, notWhenAMateTouchedItInside) {
  passTo(0.9);
  cycle(&mate);
  EXPECT_GT(game.passScoreWait[0], 9);
  shoot();
  EXPECT_EQ(game.mode, PlayMode::goalKickRight);
}

TEST_F(PassGoal, notWhenOnlyThePasserTouchedIt) {
  passTo(2);
  cycle(&passer);
  shoot();
  EXPECT_EQ(game.mode, PlayMode::goalKickRight);
}

TEST_F(PassGoal, ofTheOthersCounts) {
  passTo(3);
  ball(-14.9, 0);
  cycle();
  ball(-15.1, 0);
  cycle();
  EXPECT_EQ(game.score[1], 1);
}

}  // namespace
}  // namespace plumbline::simulation
