#include "RefereeFixture.h"

namespace plumbline::simulation {
namespace {

class KickOff : public test::RefereeTest {};

TEST_F(KickOff, beforeItTheBallStaysInTheMiddleAndTheClockStands) {
  ball(1, 2);
  cycle();
  EXPECT_EQ(ball(), Vec3(1, 2, 0.042)) << "with nobody there it may lie anywhere";
  add(left, 2, -3, 0);
  pass(5);
  EXPECT_EQ(ball(), Vec3(0, 0, 0.042));
  EXPECT_EQ(game.time, 0);
  EXPECT_EQ(game.mode, PlayMode::beforeKickOff);
}

TEST_F(KickOff, beforeItEverybodyStandsInTheOwnHalf) {
  auto &stray = add(left, 2, 1, 3), &home = add(left, 3, -0.4, -4), &guest = add(right, 2, -5, -2);
  cycle();
  EXPECT_LT((place(stray) - Vec3(-2.5, 3, standing)).norm(), 1e-9);
  EXPECT_EQ(place(home).x(), -0.4);
  EXPECT_LT((place(guest) - Vec3(2.5, -2, standing)).norm(), 1e-9);
}

TEST_F(KickOff, playersMayBeginAnywhereIfSet) {
  rules.moves.startAnywhere = true;
  auto& stray = add(left, 2, 1, 3);
  cycle();
  EXPECT_EQ(moves(stray), 0);
}

TEST_F(KickOff, othersKeepOutOfTheRingOwnPlayersMayStandInIt) {
  auto &taker = add(left, 2, -0.3, 0), &inRing = add(left, 3, 0.6, 0.5), &across = add(left, 4, 3, 4);
  auto &near = add(right, 2, 2.1, 0), &far = add(right, 3, 2.4, 6);
  referee().kickOff(game, world, left);
  EXPECT_EQ(game.mode, PlayMode::kickOffLeft);
  cycle();
  EXPECT_EQ(moves(taker) + moves(inRing) + moves(far), 0);
  EXPECT_LT((place(across) - Vec3(-2.5, 4, standing)).norm(), 1e-9);
  EXPECT_LT((place(near) - Vec3(2.5, 0, standing)).norm(), 1e-9);
}

TEST_F(KickOff, ofTheRightTeam) {
  auto &taker = add(right, 2, 0.3, 0), &near = add(left, 2, -2.1, 0);
  referee().kickOff(game, world, right);
  cycle();
  EXPECT_EQ(game.mode, PlayMode::kickOffRight);
  EXPECT_EQ(moves(taker), 0);
  EXPECT_LT((place(near) - Vec3(-2.5, 0, standing)).norm(), 1e-9);
}

TEST_F(KickOff, playIsOnWhenTheBallIsTouched) {
  auto& taker = add(right, 2, 0.3, 0);
  pass(1, &taker);
  referee().kickOff(game, world, right);
  pass(2);
  EXPECT_EQ(game.mode, PlayMode::kickOffRight) << "a touch before it does not count";
  EXPECT_NEAR(game.time, 2, 1e-9);
  cycle(&taker);
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(KickOff, goesByItselfIfSet) {
  rules.kickOff.after = 2;
  add(left, 2, -3, 0);
  pass(1.98);
  EXPECT_EQ(game.mode, PlayMode::beforeKickOff);
  pass(0.04);
  EXPECT_EQ(game.mode, PlayMode::kickOffLeft);
  game.half = 2;
  game.setMode(PlayMode::beforeKickOff);
  pass(2.02);
  EXPECT_EQ(game.mode, PlayMode::kickOffRight) << "the other team begins the second half";
}

TEST_F(KickOff, byLotEitherTeamMayBegin) {
  std::map<PlayMode, int> begun;
  for (unsigned seed = 0; seed < 40; ++seed) {
    rules.kickOff.byLot = true;
    Referee tossing(rules, RandomStream(seed));
    Game fresh;
    tossing.kickOff(fresh, world, TeamSide::none);
    ++begun[fresh.mode];
    const PlayMode first = fresh.mode;
    fresh.half = 2;
    fresh.setMode(PlayMode::beforeKickOff);
    tossing.kickOff(fresh, world, TeamSide::none);
    EXPECT_NE(fresh.mode, first) << "and the other one after the break";
  }
  EXPECT_GT(begun[PlayMode::kickOffLeft], 10);
  EXPECT_GT(begun[PlayMode::kickOffRight], 10);
}

/// Three robots: with fewer the league's server allows goals straight from the kick-off.
class KickOffGoal : public KickOff {
protected:
  Man &taker = add(left, 2, -0.3, 0), &mate = add(left, 3, -4, 4), &opponent = add(right, 2, 4, 4);
  void kickOffTaken() {
    referee().kickOff(game, world, left);
    pass(1);
    cycle(&taker);
    ASSERT_EQ(game.mode, PlayMode::playOn);
    pass(0.2);
  }
  void shoot(double x = 15.1) {
    ball(14.9 * x / 15.1, 0);
    cycle();
    ball(x, 0);
    cycle();
  }
};

TEST_F(KickOffGoal, straightFromItIsAGoalKick) {
  kickOffTaken();
  shoot();
  EXPECT_EQ(game.mode, PlayMode::goalKickRight);
  EXPECT_EQ(game.score, (std::array<int, 2>{0, 0}));
}

TEST_F(KickOffGoal, countsWithTwoRobots) {
  men.pop_back();
  kickOffTaken();
  shoot();
  EXPECT_EQ(game.mode, PlayMode::goalLeft);
}

TEST_F(KickOffGoal, countsIfTheRuleIsOff) {
  rules.kickOff.noDirectGoal = false;
  kickOffTaken();
  shoot();
  EXPECT_EQ(game.mode, PlayMode::goalLeft);
}

TEST_F(KickOffGoal, countsAfterAnOpponentsTouch) {
  kickOffTaken();
  cycle(&opponent);
  shoot();
  EXPECT_EQ(game.score, (std::array<int, 2>{1, 0}));
}

TEST_F(KickOffGoal, countsAfterATouchOfTheTeamOutsideTheRingOnly) {
  kickOffTaken();
  ball(1.9, 0);
  cycle(&mate);
  shoot();
  EXPECT_EQ(game.mode, PlayMode::goalKickRight) << "inside the ring";
  game.setMode(PlayMode::playOn);
  ball(2.1, 0);
  cycle(&mate);
  shoot();
  EXPECT_EQ(game.mode, PlayMode::goalLeft);
}

TEST_F(KickOffGoal, intoTheOwnGoalIsACornerKick) {
  kickOffTaken();
  shoot(-15.1);
  EXPECT_EQ(game.mode, PlayMode::cornerKickRight);
  EXPECT_EQ(game.score[1], 0);
}

}  // namespace
}  // namespace plumbline::simulation
