#include "RefereeFixture.h"
#include "simulation/referee/rules/BallOut.h"
#include "simulation/referee/rules/Goal.h"

namespace plumbline::simulation {
namespace {

class Goal : public test::RefereeTest {
protected:
  Man &striker = add(left, 9, 3, 3), &goalie = add(right, 1, 14, 2), &other = add(right, 2, 5, 5);
};

TEST_F(Goal, thenAPauseThenTheOthersKickOff) {
  playOn(&striker);
  ball(14.9, 0.5);
  cycle();
  ball(14.99, 0.5);
  cycle();
  EXPECT_EQ(game.mode, PlayMode::playOn);
  ball(15.01, 0.5);
  cycle();
  EXPECT_EQ(game.mode, PlayMode::goalLeft) << "the league's server counts from the ball's centre on the line";
  EXPECT_EQ(game.score, (std::array<int, 2>{1, 0}));
  ball(15.4, 0.5);
  pass(2.9);
  EXPECT_EQ(game.mode, PlayMode::goalLeft);
  EXPECT_EQ(game.score[0], 1) << "counted once";
  pass(0.12);
  EXPECT_EQ(game.mode, PlayMode::kickOffRight);
  EXPECT_EQ(ball(), Vec3(0, 0, 0.042));
  EXPECT_LT((place(striker) - Vec3(-2.5, 3, standing)).norm(), 1e-9) << "back in its half";
  EXPECT_EQ(moves(other), 0);
}

TEST_F(Goal, inTheLeftGoalIsTheRightTeams) {
  playOn(&striker);
  ball(-14.9, -1, 0.7);
  cycle();
  ball(-15.1, -1, 0.7);
  cycle();
  EXPECT_EQ(game.mode, PlayMode::goalRight);
  EXPECT_EQ(game.score, (std::array<int, 2>{0, 1}));
}

struct Miss {
  Vec3 before, after;
  const char* why;
};

TEST_F(Goal, outsideOrAboveTheGoalIsNone) {
  for (const Miss& miss : {Miss{Vec3(14.9, 1.2, 0.1), Vec3(15.1, 1.2, 0.1), "beside"},
                           Miss{Vec3(14.9, 0, 0.9), Vec3(15.02, 0, 0.85), "above the bar"},
                           Miss{Vec3(15.2, 1.3, 0.1), Vec3(15.7, 1, 0.1), "from outside, behind the net"}}) {
    playOn(&striker);
    ball(miss.before.x(), miss.before.y(), miss.before.z());
    cycle();
    game.setMode(PlayMode::playOn);
    ball(miss.after.x(), miss.after.y(), miss.after.z());
    cycle();
    EXPECT_EQ(game.score[0], 0) << miss.why;
    EXPECT_NE(game.mode, PlayMode::goalLeft) << miss.why;
  }
}

TEST_F(Goal, aFastBallIsJudgedWhereItCrossedTheLine) {
  playOn(&striker);
  world.ballState.linearVelocity = Vec3(20, 20, 0);
  ball(15.7, 1.8);  // crossed at 1.14
  cycle();
  EXPECT_EQ(game.score[0], 0);
  game.setMode(PlayMode::playOn);
  ball(15.7, 1.5);  // crossed at 0.84
  cycle();
  EXPECT_EQ(game.score[0], 1);
}

TEST_F(Goal, noneIsCountedIfTheRuleIsOff) {
  rules.of<simulation::Goal>().on = rules.of<simulation::BallOut>().on = false;
  playOn(&striker);
  ball(15.3, 0);
  pass(1);
  EXPECT_EQ(game.mode, PlayMode::playOn);
  EXPECT_EQ(game.score[0], 0);
}

}  // namespace
}  // namespace plumbline::simulation
