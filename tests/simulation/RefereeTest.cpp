#include "simulation/referee/Referee.h"

#include <gtest/gtest.h>

#include "FakeWorld.h"

namespace plumbline::simulation {
namespace {

constexpr double dt = 0.02;

class RefereeTest : public testing::Test {
protected:
  Game game;
  test::FakeWorld world;
  Rules rules;
  Referee referee{rules, Random(1)};

  void ball(double x, double y, double z = 0.042) { world.ballState.pose = translation(x, y, z); }
  Vec3 ball() const { return world.ballState.pose.translation(); }
  /// Cycles with players on the field; in the first of them the ball is touched by a side.
  void pass(double seconds, TeamSide toucher = TeamSide::none) {
    for (int i = 0; i < int(seconds / dt + 0.5); ++i) {
      Referee::Observation seen{true, {}};
      if (i == 0 && toucher != TeamSide::none) seen.touch = BallWatch::Touch{toucher, 1, 0};
      referee.update(game, world, seen, dt);
    }
  }
  void playOn(TeamSide toucher = TeamSide::left) {
    game.setMode(PlayMode::playOn);
    pass(dt, toucher);
  }
};

TEST_F(RefereeTest, beforeKickOffTheBallStaysInTheMiddleAndTheClockStands) {
  ball(1, 2);
  pass(5);
  EXPECT_EQ(ball(), Vec3(0, 0, 0.042));
  EXPECT_EQ(game.time, 0);
  EXPECT_EQ(game.mode, PlayMode::beforeKickOff);
  ball(1, 2);
  referee.update(game, world, {false, {}}, dt);
  EXPECT_EQ(ball(), Vec3(1, 2, 0.042)) << "without players it may lie anywhere";
}

TEST_F(RefereeTest, kickOffThenPlayOnWhenTouched) {
  pass(1);
  referee.kickOff(game, TeamSide::right);
  EXPECT_EQ(game.mode, PlayMode::kickOffRight);
  pass(2);
  EXPECT_EQ(game.mode, PlayMode::kickOffRight);
  EXPECT_NEAR(game.time, 2, 1e-9);
  pass(dt, TeamSide::right);
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(RefereeTest, aTouchBeforeTheKickOffDoesNotCount) {
  pass(1, TeamSide::left);
  referee.kickOff(game, TeamSide::left);
  pass(1);
  EXPECT_EQ(game.mode, PlayMode::kickOffLeft);
}

TEST_F(RefereeTest, untouchedAKickOffEndsAfterFifteenSeconds) {
  referee.kickOff(game, TeamSide::left);
  pass(15);
  EXPECT_EQ(game.mode, PlayMode::kickOffLeft);
  pass(2 * dt);
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(RefereeTest, kicksOffByItselfIfTold) {
  rules.kickOffAfter = 2;
  Referee punctual(rules, Random(1));
  for (int i = 0; i < 99; ++i) punctual.update(game, world, {true, {}}, dt);
  EXPECT_EQ(game.mode, PlayMode::beforeKickOff);
  for (int i = 0; i < 2; ++i) punctual.update(game, world, {true, {}}, dt);
  EXPECT_EQ(game.mode, PlayMode::kickOffLeft);
  game.half = 2;
  game.setMode(PlayMode::beforeKickOff);
  for (int i = 0; i < 101; ++i) punctual.update(game, world, {true, {}}, dt);
  EXPECT_EQ(game.mode, PlayMode::kickOffRight) << "the other team begins the second half";
}

TEST_F(RefereeTest, goalThenPauseThenKickOffOfTheOthers) {
  playOn();
  ball(14.9, 0.5);
  pass(dt);
  ball(15.041, 0.5);
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::playOn) << "not yet all behind the line";
  ball(15.2, 0.5);
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::goalLeft);
  EXPECT_EQ(game.score, (std::array<int, 2>{1, 0}));
  ball(15.4, 0.5);
  pass(2.9);
  EXPECT_EQ(game.mode, PlayMode::goalLeft);
  EXPECT_EQ(game.score[0], 1) << "counted once";
  pass(0.2);
  EXPECT_EQ(game.mode, PlayMode::kickOffRight);
  EXPECT_EQ(ball(), Vec3(0, 0, 0.042));
}

TEST_F(RefereeTest, goalInTheLeftGoalIsTheRightTeams) {
  playOn();
  ball(-14.9, -1, 0.7);
  pass(dt);
  ball(-15.1, -1, 0.7);
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::goalRight);
  EXPECT_EQ(game.score, (std::array<int, 2>{0, 1}));
}

struct Miss {
  Vec3 before, after;
  const char* why;
};

TEST_F(RefereeTest, besideOrAboveTheGoalIsNone) {
  for (const Miss& miss : {Miss{Vec3(14.9, 1.2, 0.1), Vec3(15.1, 1.2, 0.1), "beside"},
                           Miss{Vec3(14.9, 0, 0.9), Vec3(15.3, 0, 0.81), "above the bar where it crosses"},
                           Miss{Vec3(15.2, 1.3, 0.1), Vec3(15.7, 1, 0.1), "from outside, behind the net"}}) {
    playOn();
    world.ballState.pose = translation(miss.before);
    referee.update(game, world, {true, {}}, dt);
    game.setMode(PlayMode::playOn);
    world.ballState.pose = translation(miss.after);
    referee.update(game, world, {true, {}}, dt);
    EXPECT_EQ(game.score[0], 0) << miss.why;
    EXPECT_NE(game.mode, PlayMode::goalLeft) << miss.why;
  }
}

TEST_F(RefereeTest, aFastBallIsJudgedWhereItCrossedTheLine) {
  playOn();
  ball(14.8, 0.9);
  pass(dt);
  ball(15.4, 1.5);  // crossed at 1.14
  pass(dt);
  EXPECT_EQ(game.score[0], 0);
  game.setMode(PlayMode::playOn);
  ball(14.8, 0.6);
  pass(dt);
  ball(15.4, 1.2);  // crossed at 0.84
  pass(dt);
  EXPECT_EQ(game.score[0], 1);
}

TEST_F(RefereeTest, outAtTheSideIsAKickIn) {
  playOn(TeamSide::left);
  ball(3, 10.0);
  pass(dt);
  ball(3.1, 10.1);
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::kickInRight);
  pass(1.1);
  EXPECT_LT((ball() - Vec3(3, 10 - 0.042, 0.042)).norm(), 1e-9) << "where it was last on the field";
  pass(dt, TeamSide::right);
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(RefereeTest, duringThePauseNothingHappens) {
  playOn(TeamSide::right);
  ball(3, -10.1);
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::kickInLeft);
  pass(0.5, TeamSide::left);
  EXPECT_EQ(game.mode, PlayMode::kickInLeft) << "a touch in the pause does not count";
  EXPECT_EQ(ball().y(), -10.1);
}

TEST_F(RefereeTest, behindTheGoalLine) {
  playOn(TeamSide::left);
  ball(15.1, 3);
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::goalKickRight);
  pass(1.1);
  EXPECT_LT((ball() - Vec3(14, 0, 0.042)).norm(), 1e-9);
  pass(dt, TeamSide::right);
  EXPECT_EQ(game.mode, PlayMode::goalKickRight) << "only out of the penalty area";
  ball(13.1, 0);
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::playOn);

  playOn(TeamSide::left);
  ball(-15.1, 3);
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::cornerKickRight);
  pass(1.1);
  EXPECT_LT((ball() - Vec3(-14.958, 5.525 - 0.042, 0.042)).norm(), 1e-9);
  pass(15);
  EXPECT_EQ(game.mode, PlayMode::playOn) << "nobody came";
}

TEST_F(RefereeTest, droppedBallIsNotInThePenaltyAreaNorOutside) {
  ball(14.5, -1);
  referee.dropBall(game, world);
  EXPECT_EQ(ball(), Vec3(13.2, -3, 0.042));
  EXPECT_EQ(game.mode, PlayMode::playOn);
  ball(2, 12);
  referee.dropBall(game, world);
  EXPECT_EQ(ball().y(), 10 - 0.042);
}

TEST_F(RefereeTest, halvesAndTheEnd) {
  playOn();
  game.time = 299.99;
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::beforeKickOff);
  EXPECT_EQ(game.half, 2);
  const double time = game.time;
  pass(3);
  EXPECT_EQ(game.time, time) << "the clock stands between the halves";
  game.setMode(PlayMode::playOn);
  game.time = 599.99;
  pass(dt);
  EXPECT_EQ(game.mode, PlayMode::gameOver);
  pass(5);
  EXPECT_EQ(game.mode, PlayMode::gameOver);
  EXPECT_NEAR(game.time, 600.01, 1e-9);
}

}  // namespace
}  // namespace plumbline::simulation
