#include "tactics/approach/WalkToPlace.h"

#include <gtest/gtest.h>

#include "tactics/approach/SomeWalk.h"

namespace plumbline {
namespace {

struct WalkToPlaceTest : testing::Test {
  WalkCommand to(const Pose2& place) { return way.update(place, Vec3::Zero(), limits, detour, walk, plan); }

  WalkToPoseParameters walk;
  ApproachPlannerParameters plan;
  WalkLimits limits = test::someWalk;
  std::optional<Vec2> detour;
  WalkToPlace way;
};

TEST_F(WalkToPlaceTest, nearThePlaceItPlansAndFarAwayItDoesNot) {
  const Pose2 behind(-1, 0), far(3, 0);
  EXPECT_LT(to(behind).velocity.x(), -walk.maxBackward) << "backward, as fast as the walk can";
  EXPECT_EQ(to(far).velocity, walkToPose(far, walk).velocity);
  limits = {};
  EXPECT_EQ(to(behind).velocity, walkToPose(behind, walk).velocity)
      << "of an unknown walk nothing is planned";
}

TEST_F(WalkToPlaceTest, aDetourComesFirst) {
  detour = Vec2(0, 2);
  EXPECT_EQ(to(Pose2(-1, 0)).turn, walkPast(*detour, walk).turn);
}

TEST_F(WalkToPlaceTest, aSprintGoesOnUntilItIsNearerUnlessTheRobotStopped) {
  walk.maxForward = 1.5;
  walk.sprintBearing = 0.2;
  walk.sprintDistance = 0.5;
  EXPECT_TRUE(to(Pose2(2.5, 0)).sprint);
  EXPECT_TRUE(to(Pose2(1.5, 0)).sprint);
  way.leave();
  EXPECT_FALSE(to(Pose2(1.5, 0)).sprint);
  EXPECT_TRUE(to(Pose2(2.5, 0)).sprint);
  EXPECT_FALSE(to(Pose2(1, 0)).sprint);
}

}  // namespace
}  // namespace plumbline
