#include "RefereeFixture.h"
#include "simulation/referee/rules/BallOut.h"

namespace plumbline::simulation {
namespace {

/// Kick-ins, corner kicks, goal kicks, free kicks: from the ball's way out to play on.
class Restart : public test::RefereeTest {
protected:
  Man &ours = add(left, 7, -5, -5), &mate = add(left, 8, -6, 5);
  Man &theirs = add(right, 7, 5, -5), &rival = add(right, 8, 6, 5);
  void out(const Man& toucher, double x, double y) {
    ball(std::clamp(x, -14.9, 14.9), std::clamp(y, -9.9, 9.9));
    playOn(&toucher);
    ball(x, y);
    cycle();
  }
};

TEST_F(Restart, overTheSideLineIsAKickInForTheOthers) {
  out(ours, 3.1, 10.1);
  EXPECT_EQ(game.mode, PlayMode::kickInRight);
  pass(0.98, &theirs);
  EXPECT_EQ(game.mode, PlayMode::kickInRight) << "a touch in the pause does not count";
  EXPECT_EQ(ball().y(), 10.1) << "nor is the ball laid down yet";
  pass(0.04);
  EXPECT_LT((ball() - Vec3(3.1, 10 - 0.042, 0.042)).norm(), 1e-9) << "where it was last on the field";
  pass(0.04);
  cycle(&theirs);
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(Restart, onTheLineIsNotOut) {
  out(ours, 3, 10.042);
  EXPECT_EQ(game.mode, PlayMode::playOn);
  ball(3, 10.044);
  cycle();
  EXPECT_EQ(game.mode, PlayMode::kickInRight);
}

TEST_F(Restart, aBallNobodyTouchedStaysOutside) {
  game.setMode(PlayMode::playOn);
  ball(3, 12);
  pass(2);
  EXPECT_EQ(game.mode, PlayMode::playOn);
  EXPECT_EQ(ball(), Vec3(3, 12, 0.042));
}

TEST_F(Restart, opponentsKeepAwayOwnPlayersStepOff) {
  out(ours, 3, 10.1);  // kick-in right at (3, 9.958)
  put(ours, 2, 9);
  put(theirs, 3.3, 9.958);
  put(rival, 3, 9);
  pass(1.04);
  EXPECT_LT((place(ours) - Vec3(0.5, 9, standing)).norm(), 1e-9) << "2.5 m towards its own goal";
  EXPECT_LT((place(theirs) - Vec3(3.5, 9.958, standing)).norm(), 1e-9) << "half a metre from the ball";
  EXPECT_EQ(moves(rival), 0);
  EXPECT_EQ(moves(mate), 0);
  put(theirs, 3.3, 9.958);
  pass(0.5);
  EXPECT_LT((place(theirs) - Vec3(3.3, 9.958, standing)).norm(), 1e-9) << "only as the ball is laid down";
  put(ours, 4, 8.5);
  cycle();
  EXPECT_LT((place(ours) - Vec3(0.5, 8.5, standing)).norm(), 1e-9) << "always";
}

TEST_F(Restart, nobodyIsMovedIfTheRuleIsOff) {
  rules.restarts.keepDistance = false;
  out(ours, 3, 10.1);
  put(ours, 2, 9);
  pass(1.04);
  EXPECT_EQ(moves(ours), 0);
}

TEST_F(Restart, behindTheOpponentsLineIsAGoalKick) {
  out(ours, 15.1, 3);
  EXPECT_EQ(game.mode, PlayMode::goalKickRight);
  put(ours, 13.5, 2);
  put(mate, 12.9, 0);
  pass(1.02);
  EXPECT_LT((ball() - Vec3(14, 0, 0.042)).norm(), 1e-9);
  EXPECT_LT((place(ours) - Vec3(10.7, 2, standing)).norm(), 1e-9) << "2.5 m before the penalty area";
  EXPECT_EQ(moves(mate), 0) << "outside it may stay near";
  pass(0.04);
  cycle(&theirs);
  EXPECT_EQ(game.mode, PlayMode::goalKickRight) << "only out of the penalty area";
  ball(15.02, 1.5);
  cycle();
  EXPECT_EQ(game.mode, PlayMode::goalKickRight) << "it lies on the goal line";
  ball(13.1, 0);
  cycle();
  EXPECT_EQ(game.mode, PlayMode::playOn);

  out(theirs, -15.1, -3);
  EXPECT_EQ(game.mode, PlayMode::goalKickLeft);
  pass(1.04);
  EXPECT_LT((ball() - Vec3(-14, 0, 0.042)).norm(), 1e-9);
}

TEST_F(Restart, behindTheOwnLineIsACornerKick) {
  out(ours, -15.1, 3);
  EXPECT_EQ(game.mode, PlayMode::cornerKickRight);
  pass(1.02);
  EXPECT_LT((ball() - Vec3(-14.958, 5.525 - 0.042, 0.042)).norm(), 1e-9);
  pass(0.04);
  cycle(&theirs);
  EXPECT_EQ(game.mode, PlayMode::playOn);

  out(theirs, 15.1, -3);
  EXPECT_EQ(game.mode, PlayMode::cornerKickLeft);
  pass(1.02);
  EXPECT_LT((ball() - Vec3(14.958, -(5.525 - 0.042), 0.042)).norm(), 1e-9);
}

TEST_F(Restart, aKickNobodyTakesIsDropped) {
  out(ours, 3, 10.1);
  put(theirs, 3.6, 9.5);
  pass(15);
  EXPECT_EQ(game.mode, PlayMode::kickInRight);
  pass(0.04);
  EXPECT_EQ(game.mode, PlayMode::playOn);
  EXPECT_LT((ball() - Vec3(3, 9.958, 0.042)).norm(), 1e-9);
  EXPECT_LT((place(theirs) - Vec3(5.5, 9.5, standing)).norm(), 1e-9) << "now its own side keeps away, too";
}

TEST_F(Restart, itWaitsForEverWithoutADropBall) {
  rules.time.dropBall = 0;
  out(ours, 3, 10.1);
  pass(60);
  EXPECT_EQ(game.mode, PlayMode::kickInRight);
}

TEST_F(Restart, aFreeKickIsNotInAPenaltyArea) {
  ball(14, -2);
  playOn(&ours);
  game.setMode(PlayMode::freeKickLeft);
  pass(1.02);
  EXPECT_LT((ball() - Vec3(13.2, -3, 0.042)).norm(), 1e-9);
  ball(-14, 2);
  playOn(&theirs);
  game.setMode(PlayMode::directFreeKickRight);
  pass(1.02);
  EXPECT_LT((ball() - Vec3(-13.2, 3, 0.042)).norm(), 1e-9);
}

TEST_F(Restart, leavingTheFieldMeansNothingIfTheRuleIsOff) {
  rules.of<simulation::BallOut>().on = false;
  out(ours, 3, 12);
  pass(3);
  EXPECT_EQ(game.mode, PlayMode::playOn);
  EXPECT_EQ(ball(), Vec3(3, 12, 0.042));
}

TEST_F(Restart, aDroppedBallIsNotInThePenaltyAreaNorOutside) {
  ball(14.5, -1);
  referee().dropBall(game, world);
  EXPECT_EQ(ball(), Vec3(13.2, -3, 0.042));
  EXPECT_EQ(game.mode, PlayMode::playOn);
  ball(2, 12);
  referee().dropBall(game, world);
  EXPECT_EQ(ball().y(), 10 - 0.042);
}

/// Who may touch the ball next, and score.
class TakenKick : public Restart {
protected:
  void take(PlayMode mode, const Man& taker, double x = 5, double y = 0) {
    ball(x, y);
    playOn(&mate);
    game.setMode(mode);
    pass(1.04);
    pass(0.06, &taker);
    ASSERT_EQ(game.mode, PlayMode::playOn);
  }
  void shoot(double x) {
    ball(14.9 * x / 15.1, 0);
    cycle();
    ball(x, 0);
    cycle();
  }
};

TEST_F(TakenKick, theTakerMustNotTouchTheBallAgain) {
  take(PlayMode::kickInLeft, ours);
  pass(0.04, &ours);
  EXPECT_EQ(game.mode, PlayMode::playOn) << "within a tenth of a second it is the same kick";
  pass(1);
  ball(6, 1);
  cycle();
  cycle(&ours);
  EXPECT_EQ(game.mode, PlayMode::freeKickRight);
  pass(1.04);
  EXPECT_LT((ball() - Vec3(6, 1, 0.042)).norm(), 1e-9);
}

TEST_F(TakenKick, afterAnotherPlayerTheTakerMay) {
  take(PlayMode::cornerKickLeft, ours);
  cycle(&rival);
  pass(0.2);
  cycle(&ours);
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(TakenKick, theTakerMayIfTheRuleIsOff) {
  rules.restarts.doubleTouch = false;
  take(PlayMode::kickInLeft, ours);
  pass(1);
  cycle(&ours);
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(TakenKick, anIndirectGoalIsAGoalKick) {
  for (const PlayMode mode : {PlayMode::kickInLeft, PlayMode::freeKickLeft}) {
    take(mode, ours);
    shoot(15.1);
    EXPECT_EQ(game.mode, PlayMode::goalKickRight);
  }
  EXPECT_EQ(game.score[0], 0);
  take(PlayMode::freeKickLeft, ours);
  cycle(&rival);
  shoot(15.1);
  EXPECT_EQ(game.mode, PlayMode::goalLeft) << "off an opponent it counts";
}

TEST_F(TakenKick, aDirectGoalCounts) {
  take(PlayMode::directFreeKickLeft, ours);
  shoot(15.1);
  EXPECT_EQ(game.mode, PlayMode::goalLeft);
  game.setMode(PlayMode::playOn);
  take(PlayMode::cornerKickLeft, ours);
  shoot(15.1);
  EXPECT_EQ(game.score[0], 2);
}

TEST_F(TakenKick, intoTheOwnGoalIsACornerKick) {
  take(PlayMode::directFreeKickLeft, ours);
  shoot(-15.1);
  EXPECT_EQ(game.mode, PlayMode::cornerKickRight);
  EXPECT_EQ(game.score[1], 0);
}

TEST_F(TakenKick, anIndirectGoalCountsIfTheRuleIsOff) {
  rules.restarts.noIndirectGoal = false;
  take(PlayMode::kickInLeft, ours);
  shoot(15.1);
  EXPECT_EQ(game.mode, PlayMode::goalLeft);
}

}  // namespace
}  // namespace plumbline::simulation
