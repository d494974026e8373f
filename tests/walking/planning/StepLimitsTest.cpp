#include "walking/planning/StepLimits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simspark/LeagueRobots.h"

namespace plumbline::walking {
namespace {

class StepLimitsTest : public testing::Test {
protected:
  RobotModel robot = simsparkRobot(0);
  LegKinematics leg{robot, Side::left};
  WalkParameters p;
};

TEST_F(StepLimitsTest, areTheWalksParameters) {
  p.step.maxForward = 0.11;
  p.step.maxBackward = 0.07;
  p.step.maxOutward = 0.13;
  p.step.minFeetDistance = 0.08;
  p.step.minDuration = 0.1;
  p.step.maxDuration = 0.4;
  p.model.copForward = 0.012;
  p.startStop.calmRate = 5;
  p.startStop.calmTime = 0.2;
  const StepLimits limits = stepLimits(p, leg);
  EXPECT_EQ(limits.forward, 0.11);
  EXPECT_EQ(limits.backward, 0.07);
  EXPECT_EQ(limits.maxOutward, 0.13);
  EXPECT_EQ(limits.minOutward, 0.04) << "of each foot from the middle";
  EXPECT_EQ(limits.minDuration, 0.1);
  EXPECT_EQ(limits.maxDuration, 0.4);
  EXPECT_EQ(limits.restX, 0.012);
  EXPECT_EQ(limits.calmRate, 5);
  EXPECT_EQ(limits.calmTime, 0.2);
}

TEST_F(StepLimitsTest, bothLegsReachAlike) {
  const StepLimits left = stepLimits(p, leg), right = stepLimits(p, LegKinematics(robot, Side::right));
  EXPECT_NEAR(left.hipY, 0.055, 1e-9);
  EXPECT_EQ(left.hipY, right.hipY);
  EXPECT_EQ(left.reach, right.reach);
}

TEST_F(StepLimitsTest, aLowerHipLeavesTheLegMoreReach) {
  p.posture.hipHeight = 0.2;
  const double low = stepLimits(p, leg).reach;
  p.posture.hipHeight = 0.25;
  const double high = stepLimits(p, leg).reach;
  EXPECT_GT(low, high);
  // By Pythagoras the leg's length gives both.
  const double drop = 0.25 - leg.ankleHeight();
  EXPECT_NEAR(std::hypot(high / 0.95, drop), leg.maxReach(), 1e-9);
  EXPECT_NEAR(std::hypot(low / 0.95, 0.2 - leg.ankleHeight()), leg.maxReach(), 1e-9);
}

TEST_F(StepLimitsTest, aHipAboveTheLegsLengthReachesNowhere) {
  p.posture.hipHeight = 0.4;
  EXPECT_EQ(stepLimits(p, leg).reach, 0);
}

}  // namespace
}  // namespace plumbline::walking
