#include "walking/planning/SpeedControl.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::walking {
namespace {

WalkParameters limits() {
  WalkParameters p;
  p.speed.maxForward = 1.0;
  p.speed.omniForward = 0.6;
  p.speed.maxBackward = 0.4;
  p.speed.maxSideways = 0.3;
  p.speed.maxTurn = 2;
  p.speed.accelerationForward = p.speed.decelerationForward = 1;
  p.speed.accelerationSideways = 1;
  p.speed.accelerationTurn = 10;
  p.sprint.patience = 0.3;
  return p;
}

class SpeedControlTest : public testing::Test {
protected:
  WalkParameters p = limits();
  SpeedControl speed;

  void ask(double x, double y, double turn, double seconds) {
    for (int i = 0; i < std::lround(seconds / 0.02); ++i) speed.update(Vec2(x, y), turn, p, 1, 0.02);
  }
};

TEST_F(SpeedControlTest, mixturesStayWithinTheEllipsoidOfWhatMayBeMixed) {
  ask(1, 0.3, 2, 5);
  EXPECT_FALSE(speed.sprinting());
  const double effort = Vec3(speed.velocity().x() / 0.6, speed.velocity().y() / 0.3, speed.turn() / 2).norm();
  EXPECT_LE(effort, 1 + 1e-9);
  EXPECT_GT(effort, 0.5);
}

TEST_F(SpeedControlTest, oneDirectionAloneIsWalkedAtFullSpeedOnceItIsMeant) {
  ask(9, 0, 0, 0.5);
  EXPECT_FALSE(speed.sprinting()) << "first at the speed of mixtures";
  ask(9, 0, 0, 1);
  EXPECT_TRUE(speed.sprinting());
  EXPECT_NEAR(speed.velocity().x(), 1.0, 1e-9);
}

TEST_F(SpeedControlTest, aSprintIsBrokenOffAtOnceAndGoesBackToMixturesFirst) {
  ask(9, 0, 0, 0.8);
  ASSERT_TRUE(speed.sprinting());
  const double rising = speed.velocity().x();
  ASSERT_LT(rising, 0.9);
  ask(0.7, 0.2, 0, 0.04);
  EXPECT_LT(speed.velocity().x(), rising) << "it need not come to its full speed";
  EXPECT_LE(speed.velocity().y(), 0.23 * 0.3 + 1e-9) << "and stays straight until then";
  ask(0.7, 0, 0, 2);
  EXPECT_FALSE(speed.sprinting());
  EXPECT_NEAR(speed.velocity().x(), 0.6, 1e-9) << "and then is what may be mixed";
}

TEST_F(SpeedControlTest, aSprintSetsInAndEndsOverTimesOfItsOwn) {
  p.sprint.riseTime = 2;
  p.sprint.fallTime = 0.5;
  ask(9, 0, 0, 0.9);
  const double before = speed.velocity().x();
  ask(9, 0, 0, 0.5);
  EXPECT_NEAR(speed.velocity().x() - before, 0.5 * (1.0 - 0.6) / 2, 1e-9);
  ask(9, 0, 0, 3);
  ASSERT_NEAR(speed.velocity().x(), 1.0, 1e-9);
  ask(0, 0, 0, 0.24);
  EXPECT_NEAR(speed.velocity().x(), 1.0 - 0.24 * (1.0 - 0.6) / 0.5, 1e-9);
}

TEST_F(SpeedControlTest, afterASprintTheRobotGoesStraightForAMoment) {
  p.sprint.settleTime = 0.4;
  ask(9, 0, 0, 2);
  ask(0.6, 0.3, 2, 0.4 + 0.3);  // back to 0.6 m/s, and most of the moment
  EXPECT_TRUE(speed.sprinting());
  EXPECT_LE(std::hypot(speed.velocity().y() / 0.3, speed.turn() / 2), 0.23 * std::sqrt(2) + 1e-9);
  ask(0.6, 0.3, 2, 1);
  EXPECT_FALSE(speed.sprinting());
  EXPECT_GT(std::hypot(speed.velocity().y() / 0.3, speed.turn() / 2), 0.4);
}

TEST_F(SpeedControlTest, brakingIsTheMeanDecelerationTowardsZero) {
  ask(0.5, 0, 0, 0.4);
  EXPECT_EQ(speed.braking(), 0) << "it speeds up";
  ask(0.5, 0, 0, 2);
  ask(0, 0, 0, 0.3);
  EXPECT_LT(speed.braking(), -0.9 * (1 - std::exp(-3.0)));
  EXPECT_GT(speed.braking(), -1);
  ask(0, 0, 0, 2);
  EXPECT_EQ(speed.braking(), 0);
  ask(-0.3, 0, 0, 2);
  ask(0, 0, 0, 0.2);
  EXPECT_GT(speed.braking(), 0.7) << "of a walk backward it is positive";
}

TEST_F(SpeedControlTest, aTenthOfASecondAfterItsBeginningTwoThirdsOfABrakingAreSeen) {
  ask(0.5, 0, 0, 2);
  ask(0, 0, 0, 0.1);
  EXPECT_NEAR(speed.braking(), -0.65, 0.06);
}

TEST_F(SpeedControlTest, littleElseIsWalkedDuringASprint) {
  ask(9, 0, 0, 2);
  ask(1, 0.03, 0.3, 1);
  EXPECT_TRUE(speed.sprinting());
  EXPECT_NEAR(speed.velocity().x(), 1.0, 1e-9);
  EXPECT_GT(speed.turn(), 0.2);
  EXPECT_LE(std::hypot(speed.velocity().y() / 0.3, speed.turn() / 2), 0.23 + 1e-9);
  EXPECT_NEAR(speed.turn(), 0.3, 1e-9);
  // The wish may be more than is walked, but a real curve ends it.
  p.sprint.lateralShare = 0.05;
  ask(1, 0, 0.3, 1);
  EXPECT_TRUE(speed.sprinting());
  EXPECT_NEAR(speed.turn(), 0.05 * 2, 1e-9);
  ask(1, 0, 0.5, 1);
  EXPECT_FALSE(speed.sprinting());
}

TEST_F(SpeedControlTest, withoutSpeedsForMixturesFullSpeedIsWhatMayBeMixed) {
  ask(-9, 0, 0, 2);
  EXPECT_FALSE(speed.sprinting());
  EXPECT_NEAR(speed.velocity().x(), -0.4, 1e-9);
}

TEST_F(SpeedControlTest, aStartTakesItsFirstStepAtASpeedAtOnce) {
  p.startStop.speed = 0.15;
  speed.begin(Vec2(0.1, 0.2), p);
  EXPECT_EQ(speed.velocity(), Vec2(0.1, 0)) << "no more than asked for, and sideways as ever";
  speed.reset();
  speed.begin(Vec2(-9, 0), p);
  EXPECT_EQ(speed.velocity(), Vec2(-0.15, 0));
  ask(-9, 0, 0, 0.2);
  const Vec2 going = speed.velocity();
  EXPECT_NEAR(going.x(), -0.35, 1e-9);
  speed.begin(Vec2(-9, 0), p);
  EXPECT_EQ(speed.velocity(), going) << "a cycle later it still stands: it is not slowed down";
  p.startStop.speed = 0;
  speed.reset();
  speed.begin(Vec2(1, 0), p);
  EXPECT_EQ(speed.velocity(), Vec2(0, 0));
}

}  // namespace
}  // namespace plumbline::walking
