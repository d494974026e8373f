#include "modules/behavior/striker/KickChoice.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

struct KickChoiceTest : testing::Test {
  KickChoiceTest() {
    situation.robot = Pose2(-1, 0, 0);
    situation.reach = 4;
  }
  void add(bool mate, const Vec2& place, bool fallen = false) {
    OtherRobot& robot = situation.others.emplace_back();
    robot.mate = mate;
    robot.position = place;
    robot.fallen = fallen;
  }
  double choose(double last = 100) { return chooseKick(situation, last, parameters); }
  KickSituation situation;
  KickChoiceParameters parameters;
};

TEST_F(KickChoiceTest, straightAtTheGoalWhereNothingIsInTheWay) { EXPECT_NEAR(choose(), 0, 1e-9); }

TEST_F(KickChoiceTest, pastAnOpponentInTheWay) {
  add(false, {2, 0});
  EXPECT_GT(std::abs(choose()), 0.15);
  EXPECT_LT(std::abs(choose()), 1.2);
}

TEST_F(KickChoiceTest, toTheSideWhereAMateIs) {
  add(false, {2, 0});
  add(true, {3, -2.5});
  EXPECT_LT(choose(), -0.15);
  situation.others.back().position.y() = 2.5;
  EXPECT_GT(choose(), 0.15);
}

TEST_F(KickChoiceTest, underPressureWithoutGoingRoundTheBall) {
  situation.robot = Pose2(0, -1, pi / 2);
  const double free = choose();
  add(false, {0.8, 0.3});
  EXPECT_GT(choose(), free + 0.1);
}

TEST_F(KickChoiceTest, notOverTheSideLine) {
  situation.ball = {0, 9.5};
  situation.robot = Pose2(-0.7, 8.8, pi / 4);
  EXPECT_LT(choose(), 0.06);
}

TEST_F(KickChoiceTest, staysWithItsChoice) {
  add(false, {2, 0});
  const double right = choose(-0.5), left = choose(0.5);
  EXPECT_NEAR(chooseKick(situation, left, parameters), left, 1e-9);
  EXPECT_NEAR(chooseKick(situation, right, parameters), right, 1e-9);
}

TEST_F(KickChoiceTest, theFallenDoNotPress) {
  add(false, {0.5, 0}, true);
  EXPECT_GT(nearestOpponent(situation.others, situation.ball), 100);
}

}  // namespace
