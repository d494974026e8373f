#include "tactics/Arrival.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

const MovingSpeeds movingSpeeds{0.8, 2};

TEST(Arrival, isWhenItHasTurnedAndWalked) {
  MovingRobot robot{.position = {1, 0}};
  EXPECT_NEAR(secondsTo(robot, {5, 0}, movingSpeeds), 5, 1e-9) << "its heading is not known";
  robot.heading = 0;
  EXPECT_NEAR(secondsTo(robot, {5, 0}, movingSpeeds), 5, 1e-9);
  EXPECT_NEAR(secondsTo(robot, {-3, 0}, movingSpeeds), 5 + pi / 2, 1e-9);
  EXPECT_NEAR(secondsTo(robot, {0.8, 0}, movingSpeeds), 0.25, 1e-9) << "a step back";
}

TEST(Arrival, whoWalksLooksWhereItGoes) {
  MovingRobot robot{.velocity = {0.6, 0}};
  EXPECT_NEAR(secondsTo(robot, {4, 0}, movingSpeeds), 5, 1e-9);
  EXPECT_NEAR(secondsTo(robot, {0, 4}, movingSpeeds), 5 + pi / 4, 1e-9);
  robot.velocity = {0.2, 0};
  EXPECT_NEAR(secondsTo(robot, {0, 4}, movingSpeeds), 5, 1e-9) << "noise";
}

TEST(Arrival, theFallenGetUpFirst) {
  const MovingRobot robot{.getUpSeconds = 4};
  EXPECT_NEAR(secondsTo(robot, {4, 0}, movingSpeeds), 9, 1e-9);
  const MovingRobot later = movedOn(robot, 1.5, movingSpeeds);
  EXPECT_EQ(later.position, Vec2(0, 0));
  EXPECT_NEAR(later.getUpSeconds, 2.5, 1e-9);
}

TEST(Arrival, whoHasAPlaceComesNearerToItAndStopsThere) {
  MovingRobot robot{.velocity = {0, 0.7}, .heading = pi / 2};
  robot.place = Pose2(4, 0, -1);
  const MovingRobot later = movedOn(robot, 2, movingSpeeds);
  EXPECT_TRUE(later.position.isApprox(Vec2(1.6, 0)));
  EXPECT_NEAR(later.heading.value(), 0, 1e-9) << "it looks where it goes";
  EXPECT_TRUE(later.velocity.isApprox(Vec2(0.8, 0)));
  const MovingRobot there = movedOn(robot, 9, movingSpeeds);
  EXPECT_EQ(there.position, Vec2(4, 0));
  EXPECT_EQ(there.heading.value(), -1);
  EXPECT_EQ(there.velocity, Vec2(0, 0));
  robot.getUpSeconds = 1;
  EXPECT_TRUE(movedOn(robot, 2, movingSpeeds).position.isApprox(Vec2(0.8, 0)));
  robot.place = Pose2(0, 0, 2);
  EXPECT_EQ(movedOn(robot, 2, movingSpeeds).heading.value(), 2) << "it is there already";
}

TEST(Arrival, otherwiseItGoesOnForASecondNoFasterThanRobotsWalk) {
  MovingRobot robot{.velocity = {0.5, 0}};
  EXPECT_TRUE(movedOn(robot, 0.4, movingSpeeds).position.isApprox(Vec2(0.2, 0)));
  EXPECT_TRUE(movedOn(robot, 5, movingSpeeds).position.isApprox(Vec2(0.5, 0)));
  robot.velocity = {1.6, 0};
  EXPECT_TRUE(movedOn(robot, 5, movingSpeeds).position.isApprox(Vec2(0.8, 0)));
  robot.velocity = {0.2, 0};
  EXPECT_EQ(movedOn(robot, 5, movingSpeeds).position, Vec2(0, 0));
}

}  // namespace
