#include "walking/estimation/SupportSwitch.h"

#include <gtest/gtest.h>

namespace plumbline::walking {
namespace {

class SupportSwitchTest : public testing::Test {
protected:
  SupportSwitchTest() {
    p.contact.share = 0.3;
    p.contact.minPhase = 0.7;
    p.contact.maxWait = 0.04;
    p.step.duration = 0.25;
    state.support = Support::left;
    state.foot[0] = Pose2(-0.01, 0.05);
    state.foot[1] = Pose2(0.02, -0.06);
    planned.duration = 0.05;
    planned.turn = 0.02;
    planned.stepTarget = Pose2(0.03, -0.05);
  }
  void press(double left, double right) {
    WalkSensors sensors;
    sensors.feet.emplace();
    if (left > 0) sensors.feet->foot[0] = FootContact{Vec3::Zero(), Vec3(0, 0, left)};
    if (right > 0) sensors.feet->foot[1] = FootContact{Vec3::Zero(), Vec3(0, 0, right)};
    contact.update(sensors);
  }

  WalkParameters p;
  WalkState state;
  WalkAction planned;
  SupportSwitch contact;
};

TEST_F(SupportSwitchTest, isOffByDefault) {
  press(10, 40);
  const WalkAction same = contact.adapted(planned, state, 0.9, 0.2, 0.01, WalkParameters());
  EXPECT_EQ(same.duration, planned.duration);
  EXPECT_EQ(same.stepTarget.position, planned.stepTarget.position);
}

TEST_F(SupportSwitchTest, aPressedSwingFootCarriesWhereItIs) {
  press(30, 20);
  const WalkAction over = contact.adapted(planned, state, 0.8, 0.2, 0.01, p);
  EXPECT_EQ(over.duration, 0);
  EXPECT_EQ(over.turn, 0);
  EXPECT_EQ(over.stepTarget.position, state.foot[1].position);
}

TEST_F(SupportSwitchTest, notAtTheBeginningOfAStepAndNotForALittle) {
  press(30, 20);
  EXPECT_EQ(contact.adapted(planned, state, 0.5, 0.12, 0.01, p).duration, planned.duration);
  press(45, 5);
  EXPECT_EQ(contact.adapted(planned, state, 0.8, 0.2, 0.01, p).duration, planned.duration);
}

TEST_F(SupportSwitchTest, waitsForTheGroundButNotForLong) {
  press(50, 0);
  planned.duration = 0.005;
  EXPECT_GT(contact.adapted(planned, state, 0.98, 0.245, 0.01, p).duration, 0.01);
  EXPECT_EQ(contact.adapted(planned, state, 1, 0.285, 0.01, p).duration, 0.005);
}

TEST_F(SupportSwitchTest, inTheAirNothingIsPressed) {
  press(0, 0);
  EXPECT_EQ(contact.shares()[0], 0);
  EXPECT_EQ(contact.shares()[1], 0);
}

}  // namespace
}  // namespace plumbline::walking
