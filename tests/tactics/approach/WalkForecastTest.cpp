#include "tactics/approach/WalkForecast.h"

#include <gtest/gtest.h>

#include "walking/planning/SpeedControl.h"

using namespace plumbline;

namespace {

const WalkLimits limits{.forward = 0.6,
                        .backward = 0.4,
                        .sideways = 0.3,
                        .turn = 2,
                        .accelerationForward = 1.2,
                        .decelerationForward = 0.9,
                        .accelerationSideways = 0.5,
                        .accelerationTurn = 8};

TEST(WalkForecast, coastsOnAnArc) {
  const WalkPoint later = coasted({Pose2(1, 2, pi / 2), Vec3(0.5, 0, 0.1)}, 1);
  EXPECT_NEAR(later.pose.heading, pi / 2 + 0.1, 1e-12);
  EXPECT_NEAR(later.pose.x(), 1 - 0.5 * std::sin(0.05), 1e-12);
  EXPECT_NEAR(later.pose.y(), 2 + 0.5 * std::cos(0.05), 1e-12);
  EXPECT_EQ(later.speed, Vec3(0.5, 0, 0.1));
}

TEST(WalkForecast, speedsChangeAsFastAsTheLimitsSay) {
  const WalkPoint faster = walked({}, Vec3(0.6, 0, 0), limits, 0.1);
  EXPECT_NEAR(faster.speed.x(), 0.12, 1e-12);
  EXPECT_NEAR(faster.pose.x(), 0.012, 1e-12);
  EXPECT_NEAR(walked({{}, Vec3(0.6, 0, 0)}, Vec3::Zero(), limits, 0.1).speed.x(), 0.51, 1e-12);
  EXPECT_NEAR(walked({}, Vec3(0, 0.3, 0), limits, 0.1).speed.y(), 0.05, 1e-12);
}

TEST(WalkForecast, aMixtureIsWithinTheEllipsoidAndFullSpeedLeavesLittleForTurning) {
  WalkPoint robot;
  for (int i = 0; i < 100; ++i) robot = walked(robot, Vec3(-1, 1, 0), limits, 0.06);
  EXPECT_NEAR(robot.speed.x(), -0.6 * 0.4, 1e-9) << "0.6 and 0.8 of the limits are within the ellipsoid";
  EXPECT_NEAR(robot.speed.y(), 0.4 * 0.3, 1e-9) << "but 0.6 backward leaves 0.4 to the side";
  for (int i = 0; i < 100; ++i) robot = walked(robot, Vec3(0.6, 0, 0), limits, 0.06);
  robot = walked(robot, Vec3(0.6, 0, 2), limits, 0.06);
  EXPECT_LE(robot.speed.z(), 0.2 * limits.turn);
}

TEST(WalkForecast, isWhatTheWalkAimsAt) {
  walking::WalkParameters p;
  p.speed.omniForward = limits.forward;
  p.speed.omniBackward = limits.backward;
  p.speed.omniSideways = limits.sideways;
  p.speed.omniTurn = limits.turn;
  p.speed.maxForward = 2;  // no request of this test is a sprint
  p.speed.maxBackward = p.speed.maxSideways = 2;
  p.speed.maxTurn = 6;
  p.speed.accelerationForward = limits.accelerationForward;
  p.speed.decelerationForward = limits.decelerationForward;
  p.speed.accelerationSideways = limits.accelerationSideways;
  p.speed.accelerationTurn = limits.accelerationTurn;
  EXPECT_EQ(walking::walkLimits(p), limits);
  walking::SpeedControl control;
  WalkPoint robot;
  const Vec3 requests[] = {{0.6, 0, 0}, {0.5, 0.2, 1},   {-0.3, -0.2, -1.5},
                           {0, 0, 2},   {0.9, 0.1, 0.3}, {0, 0, 0}};
  for (const Vec3& request : requests)
    for (int i = 0; i < 30; ++i) {
      control.update(request.head<2>(), request.z(), p, 1, 0.02);
      robot = walked(robot, request, limits, 0.02);
      ASSERT_NEAR(robot.speed.x(), control.velocity().x(), 1e-9) << request.transpose();
      ASSERT_NEAR(robot.speed.y(), control.velocity().y(), 0.03) << request.transpose();
      ASSERT_NEAR(robot.speed.z(), control.turn(), 0.21) << request.transpose();
    }
}

}  // namespace
