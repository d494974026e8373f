#include "walking/estimation/ClosedLoop.h"

#include <gtest/gtest.h>

#include "simspark/LeagueRobots.h"
#include "walking/StandingAngles.h"
#include "walking/model/LinearInvertedPendulum.h"

namespace plumbline::walking {
namespace {

/// A robot that stands still by its sensors, while actions are under way that these do not show yet.
class ClosedLoopTest : public testing::Test {
protected:
  ClosedLoopTest() { sensors.angles = standingAngles(robot, 0.2); }
  /// A cycle in which the mass is pushed from behind: the pressure is behind it.
  void push() {
    WalkAction action;
    action.duration = dt;
    action.centerOfPressure = Vec2(-0.03, 0);
    loop.pass(action, dt);
  }
  std::optional<WalkState> measure(std::size_t delay) { return loop.update(sensors, model, delay, 0); }

  static constexpr double dt = 0.02;
  RobotModel robot = simsparkRobot(0);
  ClosedLoop loop{robot};
  LinearInvertedPendulum model{0.22};
  WalkSensors sensors;
};

TEST_F(ClosedLoopTest, knowsNothingUntilTheDelayHasPassed) {
  for (const bool known : {false, false, true, true}) {
    loop.endCycle();
    EXPECT_EQ(measure(3).has_value(), known);
  }
  loop.reset();
  loop.endCycle();
  EXPECT_FALSE(measure(3));
}

TEST_F(ClosedLoopTest, whatIsUnderWayIsPredictedOnTopOfTheObservation) {
  push();
  loop.endCycle();
  push();
  loop.endCycle();
  push();
  loop.endCycle();
  const std::optional<WalkState> state = measure(3);
  ASSERT_TRUE(state);
  WalkState expected = loop.observed().state();
  for (int i = 0; i < 2; ++i) {
    WalkAction action;
    action.duration = dt;
    action.centerOfPressure = Vec2(-0.03, 0);
    expected = model.move(expected, action, dt);
  }
  EXPECT_NEAR((state->velocity - expected.velocity).norm(), 0, 1e-12);
  EXPECT_GT(state->velocity.x(), loop.observed().state().velocity.x() + 0.02);
  EXPECT_NEAR(state->foot[0].x(), expected.foot[0].x(), 1e-12);
}

TEST_F(ClosedLoopTest, aDelayOfACycleIsTheObservationItself) {
  push();
  loop.endCycle();
  EXPECT_EQ(measure(1)->velocity, loop.observed().state().velocity);
  loop.endCycle();
  EXPECT_TRUE(measure(0)) << "taken as one";
}

TEST_F(ClosedLoopTest, aFootThatLandsIsPutWhereItLandedAndCarries) {
  WalkAction step;
  step.duration = dt;
  loop.pass(step, dt);
  loop.land(Pose2(0, -0.11), Support::left);
  loop.endCycle();
  EXPECT_EQ(measure(1)->support, Support::left) << "that is observed already";
  loop.pass(step, dt);
  loop.land(Pose2(0.05, -0.12), Support::right);
  loop.endCycle();
  const std::optional<WalkState> state = measure(2);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->support, Support::right);
  const Pose2 landed = state->foot[0].inverse() * state->foot[1];
  EXPECT_NEAR((landed.position - Vec2(0.05, -0.12)).norm(), 0, 1e-9);
}

TEST_F(ClosedLoopTest, moreChangesThanFitInACycleAreLeftOut) {
  for (int i = 0; i < 10; ++i) push();
  loop.endCycle();
  loop.endCycle();
  EXPECT_TRUE(measure(2));
}

}  // namespace
}  // namespace plumbline::walking
