#include "RefereeFixture.h"

namespace plumbline::simulation {
namespace {

class HalfTime : public test::RefereeTest {
protected:
  Man& ours = add(left, 7, -5, -5);
};

TEST_F(HalfTime, stopsTheClockThenTheGameEnds) {
  playOn();
  game.time = 299.97;
  cycle();
  EXPECT_EQ(game.mode, PlayMode::playOn);
  cycle();
  EXPECT_EQ(game.mode, PlayMode::beforeKickOff);
  EXPECT_EQ(game.half, 2);
  EXPECT_FALSE(changedSides) << "in the league teams stay on their side";
  const double time = game.time;
  pass(3);
  EXPECT_EQ(game.time, time) << "the clock stands between the halves";
  game.setMode(PlayMode::playOn);
  game.time = 599.99;
  cycle();
  EXPECT_EQ(game.mode, PlayMode::gameOver);
  pass(5);
  EXPECT_EQ(game.mode, PlayMode::gameOver);
  EXPECT_NEAR(game.time, 600.01, 1e-9);
}

TEST_F(HalfTime, isWhenTheRulesSaySo) {
  rules.time.half = 10;
  playOn();
  pass(10);
  EXPECT_EQ(game.half, 2);
}

TEST_F(HalfTime, aGameMayHaveOneHalf) {
  rules.time.singleHalf = true;
  playOn();
  game.time = 299.99;
  cycle();
  EXPECT_EQ(game.mode, PlayMode::gameOver);
  EXPECT_EQ(game.half, 1);
}

TEST_F(HalfTime, teamsChangeEndsIfSet) {
  rules.time.changeSides = true;
  game.teams = {"A", "B"};
  game.score = {3, 1};
  referee().kickOff(game, world, TeamSide::none);
  EXPECT_EQ(game.mode, PlayMode::kickOffLeft);
  playOn();
  game.time = 299.99;
  cycle();
  EXPECT_TRUE(changedSides);
  EXPECT_EQ(game.teams, (std::array<std::string, 2>{"B", "A"}));
  EXPECT_EQ(game.score, (std::array<int, 2>{1, 3}));
  EXPECT_EQ(place(ours).x(), 2.5) << "now a right player, it is put into its new half";
  referee().kickOff(game, world, TeamSide::none);
  EXPECT_EQ(game.mode, PlayMode::kickOffLeft) << "of the team that did not begin";
}

}  // namespace
}  // namespace plumbline::simulation
