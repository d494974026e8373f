#include "RefereeFixture.h"
#include "simulation/referee/rules/Incapable.h"

namespace plumbline::simulation {
namespace {

using Fouls = std::vector<std::pair<Foul::Kind, int>>;

class Incapable : public test::RefereeTest {
protected:
  Man &player = add(left, 4, -5, 2), &goalie = add(right, 1, 14.5, 0);
  Incapable() { ball(0, 4); }
};

TEST_F(Incapable, whoLiesTooLongIsPutOffTheField) {
  put(player, -5, 2, 0.1);
  playOn();
  pass(14.98);
  EXPECT_EQ(moves(player), 0);
  EXPECT_EQ(fouls(), Fouls{});
  pass(0.02);
  EXPECT_LT((place(player) - Vec3(-5, 2, 1.02)).norm(), 1e-9) << "held in the air";
  EXPECT_EQ(fouls(), (Fouls{{Foul::Kind::incapable, 4}}));
  pass(0.48);
  EXPECT_LT((place(player) - Vec3(-5, 2, 1.26)).norm(), 1e-9);
  pass(0.02);
  EXPECT_LT((place(player) - Vec3(-0.6 * 3, -10.5, 0.4)).norm(), 1e-9) << "on the side away from the ball";
  EXPECT_EQ(game.fouls.count(), 26) << "reported in every cycle, as by the league's server";
  EXPECT_EQ(game.mode, PlayMode::playOn);
}

TEST_F(Incapable, ofTheRightTeamAndWithTheBallBelow) {
  auto& other = add(right, 9, 3, 3, 0.1);
  ball(0, -4);
  playOn();
  pass(15.5);
  EXPECT_LT((place(other) - Vec3(0.6 * (7 - 9), 10.5, 0.4)).norm(), 1e-9);
}

TEST_F(Incapable, whoDoesNotStandHasThirtySeconds) {
  put(player, -5, 2, 0.2);
  playOn();
  pass(29.98);
  EXPECT_EQ(moves(player), 0);
  pass(0.02);
  EXPECT_EQ(place(player).z(), 1.02);
}

TEST_F(Incapable, standingForHalfASecondStartsAnew) {
  put(player, -5, 2, 0.1);
  playOn();
  pass(14);
  put(player, -5, 2);
  pass(0.54);
  put(player, -5, 2, 0.1);
  pass(14.9);
  EXPECT_EQ(moves(player), 0);
}

TEST_F(Incapable, aShortRiseCountsForLyingOnly) {
  put(player, -5, 2, 0.1);
  playOn();
  pass(14);
  put(player, -5, 2);
  pass(0.2);
  put(player, -5, 2, 0.1);
  pass(14);
  EXPECT_EQ(moves(player), 0) << "28.2 s of not standing, 14 s of lying";
  put(player, -5, 2, 0.2);
  pass(2);
  EXPECT_GT(moves(player), 0) << "it never stood for half a second";
}

TEST_F(Incapable, theGoalieHasTwiceTheTime) {
  put(goalie, 14.5, 0, 0.1);
  playOn();
  pass(29.9);
  EXPECT_EQ(moves(goalie), 0);
  pass(0.2);
  EXPECT_GT(moves(goalie), 0);
  put(goalie, 14.5, 0, 0.2);
  pass(1);
  put(goalie, 14.5, 0, 0.2);
  const int before = moves(goalie);
  pass(59.4);
  EXPECT_EQ(moves(goalie), before);
  pass(1);
  EXPECT_GT(moves(goalie), before);
}

TEST_F(Incapable, offTheFieldNobodyHasToStand) {
  put(player, -5, 10.2, 0.1);
  playOn();
  pass(20);
  EXPECT_EQ(moves(player), 0);
}

TEST_F(Incapable, whileTheGameStandsNothingIsCounted) {
  put(player, -5, 2, 0.1);
  pass(20);
  EXPECT_EQ(fouls(), Fouls{});
  playOn();
  pass(14);
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Incapable, isNoFoulIfTheRuleIsOff) {
  rules.of<simulation::Incapable>().on = false;
  put(player, -5, 2, 0.1);
  playOn();
  pass(40);
  EXPECT_EQ(moves(player), 0);
}

}  // namespace
}  // namespace plumbline::simulation
