#include "tactics/Arrival.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

const WalkerSpeeds walkerSpeeds{0.8, 2};

TEST(Arrival, isWhenItHasTurnedAndWalked) {
  Walker robot{.position = {1, 0}};
  EXPECT_NEAR(secondsTo(robot, {5, 0}, walkerSpeeds), 5, 1e-9) << "its heading is not known";
  robot.heading = 0;
  EXPECT_NEAR(secondsTo(robot, {5, 0}, walkerSpeeds), 5, 1e-9);
  EXPECT_NEAR(secondsTo(robot, {-3, 0}, walkerSpeeds), 5 + pi / 2, 1e-9);
  EXPECT_NEAR(secondsTo(robot, {0.8, 0}, walkerSpeeds), 0.25, 1e-9) << "a step back";
}

TEST(Arrival, whoWalksLooksWhereItGoes) {
  Walker robot{.velocity = {0.6, 0}};
  EXPECT_NEAR(secondsTo(robot, {4, 0}, walkerSpeeds), 5, 1e-9);
  EXPECT_NEAR(secondsTo(robot, {0, 4}, walkerSpeeds), 5 + pi / 4, 1e-9);
  robot.velocity = {0.2, 0};
  EXPECT_NEAR(secondsTo(robot, {0, 4}, walkerSpeeds), 5, 1e-9) << "noise";
}

TEST(Arrival, theFallenGetUpFirst) {
  const Walker robot{.lies = 4};
  EXPECT_NEAR(secondsTo(robot, {4, 0}, walkerSpeeds), 9, 1e-9);
  const Walker later = walkedOn(robot, 1.5, walkerSpeeds);
  EXPECT_EQ(later.position, Vec2(0, 0));
  EXPECT_NEAR(later.lies, 2.5, 1e-9);
}

TEST(Arrival, whoHasAPlaceComesNearerToItAndStopsThere) {
  Walker robot{.velocity = {0, 0.7}, .heading = pi / 2};
  robot.place = Pose2(4, 0, -1);
  const Walker later = walkedOn(robot, 2, walkerSpeeds);
  EXPECT_TRUE(later.position.isApprox(Vec2(1.6, 0)));
  EXPECT_NEAR(later.heading.value(), 0, 1e-9) << "it looks where it goes";
  EXPECT_TRUE(later.velocity.isApprox(Vec2(0.8, 0)));
  const Walker there = walkedOn(robot, 9, walkerSpeeds);
  EXPECT_EQ(there.position, Vec2(4, 0));
  EXPECT_EQ(there.heading.value(), -1);
  EXPECT_EQ(there.velocity, Vec2(0, 0));
  robot.lies = 1;
  EXPECT_TRUE(walkedOn(robot, 2, walkerSpeeds).position.isApprox(Vec2(0.8, 0)));
  robot.place = Pose2(0, 0, 2);
  EXPECT_EQ(walkedOn(robot, 2, walkerSpeeds).heading.value(), 2) << "it is there already";
}

TEST(Arrival, otherwiseItGoesOnForASecondNoFasterThanRobotsWalk) {
  Walker robot{.velocity = {0.5, 0}};
  EXPECT_TRUE(walkedOn(robot, 0.4, walkerSpeeds).position.isApprox(Vec2(0.2, 0)));
  EXPECT_TRUE(walkedOn(robot, 5, walkerSpeeds).position.isApprox(Vec2(0.5, 0)));
  robot.velocity = {1.6, 0};
  EXPECT_TRUE(walkedOn(robot, 5, walkerSpeeds).position.isApprox(Vec2(0.8, 0)));
  robot.velocity = {0.2, 0};
  EXPECT_EQ(walkedOn(robot, 5, walkerSpeeds).position, Vec2(0, 0));
}

}  // namespace
