#include "walking/WalkEngine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/LegKinematics.h"

namespace plumbline::walking {
namespace {

constexpr double dt = 0.02;

/// The engine with joints that are where it wants them: the open loop.
struct OpenLoop {
  RobotModel robot = simsparkRobot(0);
  WalkEngine engine{WalkParameters{}, robot};
  WalkSensors sensors;
  WalkOutput output;
  Pose2 odometry;

  void run(const WalkRequest& request, double seconds) {
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
      output = engine.update(request, sensors);
      sensors.angles = output.angles;
      odometry = odometry * output.odometry;
    }
  }
};

WalkRequest walk(double x, double y, double turn) { return {Vec2(x, y), turn, true}; }

TEST(WalkEngine, standsStillUntilAsked) {
  OpenLoop loop;
  loop.run({}, 1);
  EXPECT_TRUE(loop.output.standing);
  EXPECT_EQ(loop.output.support, Support::both);
  for (std::size_t j = 0; j < numJoints; ++j) {
    if (!loop.output.set[j]) continue;
    EXPECT_NEAR(loop.output.angles[j], loop.engine.stand().angles[j], 1e-3) << jointNames[j];
  }
  EXPECT_FALSE(loop.output.set[headYaw]);
  EXPECT_TRUE(loop.output.set[rAnkleRoll]);
  EXPECT_NEAR(loop.odometry.position.norm(), 0, 1e-3);
}

TEST(WalkEngine, walksAsFarAsAskedByItsOwnModel) {
  OpenLoop loop;
  loop.run(walk(0.3, 0, 0), 2);
  loop.odometry = {};
  loop.run(walk(0.3, 0, 0), 3.6);
  EXPECT_NEAR(loop.odometry.x(), 0.3 * 3.6, 0.02);
  EXPECT_NEAR(loop.odometry.y(), 0, 0.03);
  EXPECT_FALSE(loop.output.standing);
}

TEST(WalkEngine, turnsAsAsked) {
  OpenLoop loop;
  loop.run(walk(0, 0, 1.2), 1);
  double turned = 0;
  for (int i = 0; i < 100; ++i) {
    loop.run(walk(0, 0, 1.2), dt);
    turned += loop.output.odometry.heading;
  }
  EXPECT_NEAR(turned, 2.4, 0.1);
}

TEST(WalkEngine, leavesTheStandWithoutSteppingOnTheSpot) {
  OpenLoop loop;
  WalkParameters parameters;
  loop.run(walk(0.2, 0, 0), parameters.startDuration + parameters.stepDuration);
  EXPECT_GT(loop.engine.state().velocity.x(), 0.05) << "the first step goes forward";
}

TEST(WalkEngine, stopsWithFeetSideBySide) {
  OpenLoop loop;
  loop.run(walk(0.3, 0.1, 0.5), 3);
  loop.run({}, 2);
  EXPECT_TRUE(loop.output.standing);
  const Pose2 between = loop.engine.state().foot[1].inverse() * loop.engine.state().foot[0];
  EXPECT_NEAR(between.x(), 0, 0.02);
  EXPECT_NEAR(between.heading, 0, 0.1);
  EXPECT_LT(loop.engine.state().velocity.norm(), 0.02);
}

TEST(WalkEngine, requestsBeyondTheLimitsAreScaledDown) {
  OpenLoop loop;
  const WalkParameters parameters;
  loop.run(walk(9, 0, 0), 4);
  EXPECT_NEAR(loop.output.velocity.x(), parameters.maxForward, 1e-9);
  loop.run(walk(9, 9 * parameters.maxSideways / parameters.maxForward, 0), 4);
  EXPECT_NEAR(loop.output.velocity.x(), parameters.maxForward * std::sqrt(0.5), 1e-9);
  // The robot brakes before it turns: forward speed goes first, the side gets the rest of the effort.
  EXPECT_NEAR(loop.output.velocity.y(), parameters.maxSideways * (1 - std::sqrt(0.5)), 1e-9);
}

TEST(WalkEngine, jointsMoveWithoutJumps) {
  OpenLoop loop;
  loop.run({}, 0.2);
  JointArray last = loop.output.angles;
  for (int i = 0; i < 250; ++i) {
    loop.run(i < 200 ? walk(0.25, 0, 0.4) : WalkRequest{}, dt);
    for (std::size_t j = lShoulderPitch; j < numJoints; ++j)
      ASSERT_LT(std::abs(loop.output.angles[j] - last[j]), 6.14 * dt) << jointNames[j] << " in cycle " << i;
    last = loop.output.angles;
  }
}

TEST(WalkEngine, sameCallsSameAnswers) {
  OpenLoop a, b;
  a.run(walk(0.2, 0.1, -0.3), 3);
  b.run({}, 0);
  b.engine.reset();
  b.run(walk(0.2, 0.1, -0.3), 3);
  EXPECT_EQ(a.output.angles, b.output.angles);
}

TEST(WalkEngine, resetIsTheStand) {
  OpenLoop loop;
  loop.run(walk(0.3, 0, 0), 1.3);
  loop.engine.reset();
  loop.run({}, dt);
  EXPECT_TRUE(loop.output.standing);
  EXPECT_NEAR(loop.output.odometry.position.norm(), 0, 1e-3);
}

TEST(WalkParameters, firstBadValueIsNamed) {
  WalkParameters parameters;
  parameters.check();
  parameters.stepHeight = 0.5;
  try {
    WalkEngine engine(parameters, simsparkRobot(0));
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "walking parameter stepHeight = 0.5 must be 0.001 to 0.1");
  }
  parameters.stepHeight = std::nan("");
  EXPECT_THROW(parameters.check(), std::invalid_argument);
}

TEST(WalkParameters, theTableHoldsEveryMember) {
  EXPECT_EQ(walkParameterTable().size() * sizeof(double), sizeof(WalkParameters));
}

}  // namespace
}  // namespace plumbline::walking
