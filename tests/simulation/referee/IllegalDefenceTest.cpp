#include "RefereeFixture.h"

namespace plumbline::simulation {
namespace {

using Fouls = std::vector<std::pair<Foul::Kind, int>>;

class IllegalDefence : public test::RefereeTest {
protected:
  Man &goalie = add(left, 1, -14.8, 0), &two = add(left, 2, -14, 1.5), &three = add(left, 3, -14, -1.5);
  Man& four = add(left, 4, -12, 0.5);
  IllegalDefence() {
    ball(5, 0);
    playOn();
  }
};

TEST_F(IllegalDefence, threeMayDefend) {
  pass(5);
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(IllegalDefence, theLastToEnterIsPutOut) {
  put(four, -13.3, 0.5);
  cycle();
  EXPECT_EQ(fouls(), (Fouls{{Foul::Kind::illegalDefence, 4}}));
  EXPECT_LT((place(four) - Vec3(-12.8, 0.5, standing)).norm(), 1e-9) << "over the nearest edge";
  pass(1);
  EXPECT_EQ(game.fouls.count(), 1);
  EXPECT_EQ(moves(two) + moves(three) + moves(goalie), 0);
}

TEST_F(IllegalDefence, sidewaysIfThatIsNearer) {
  put(four, -14, 2.9);
  cycle();
  EXPECT_LT((place(four) - Vec3(-14, 3.4, standing)).norm(), 1e-9);
}

TEST_F(IllegalDefence, neverIntoTheGoal) {
  put(four, -14.9, 0.9);
  cycle();
  EXPECT_LT((place(four) - Vec3(-15.4, 1.05 + 0.4 + 0.001, standing)).norm(), 1e-9);
}

TEST_F(IllegalDefence, ifTheGoalieEntersTheFarthestGoes) {
  put(goalie, -12, 3);
  cycle();
  put(four, -13.3, 1.5);
  pass(0.1);
  EXPECT_EQ(fouls(), Fouls{}) << "three without the goalie";
  put(goalie, -14.5, 0);
  cycle();
  EXPECT_EQ(fouls(), (Fouls{{Foul::Kind::illegalDefence, 4}})) << "2.27 m from the goal's middle";
}

TEST_F(IllegalDefence, inTheRightPenaltyArea) {
  add(right, 1, 14.8, 0), add(right, 5, 14, 1.5), add(right, 6, 14, -1.5);
  auto& last = add(right, 7, 12, 0.5);
  cycle();
  EXPECT_EQ(fouls(), Fouls{});
  put(last, 13.3, 0.5);
  cycle();
  EXPECT_EQ(fouls(), (Fouls{{Foul::Kind::illegalDefence, -7}}));
  EXPECT_LT((place(last) - Vec3(12.8, 0.5, standing)).norm(), 1e-9);
}

TEST_F(IllegalDefence, attackersDoNotCount) {
  auto& attacker = add(right, 9, -13.3, 0.5);
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
  EXPECT_EQ(moves(attacker), 0);
}

class IllegalDefenceOff : public test::RefereeTest {};

TEST_F(IllegalDefenceOff, allMayDefendIfTheRuleIsOff) {
  rules.illegalDefence.on = false;
  ball(5, 0);
  playOn();
  for (int unum = 1; unum <= 6; ++unum) add(left, unum, -14.5, unum - 3.5);
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(IllegalDefenceOff, theRuleMayPutThemOffTheField) {
  rules.illegalDefence.putOutside = true;
  ball(5, 1);
  playOn();
  for (int unum = 1; unum <= 3; ++unum) add(left, unum, -14.5, unum - 2);
  cycle();
  auto& last = add(left, 5, -14.5, 2.2);
  cycle();
  EXPECT_NEAR(place(last).z(), 1.02, 1e-9);
  pass(0.5);
  EXPECT_LT((place(last) - Vec3(-1.2, -10.5, 0.4)).norm(), 1e-9);
}

}  // namespace
}  // namespace plumbline::simulation
