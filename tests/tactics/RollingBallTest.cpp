#include "tactics/RollingBall.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

TEST(RollingBall, slowsDownToItsRestingPlace) {
  const Vec2 from(1, 2), velocity(4, -2);
  EXPECT_EQ(rolledOn(from, velocity, 0), from);
  EXPECT_EQ(rolledOn(from, velocity, -1), from) << "the past is not known";
  EXPECT_LT((rolledOn(from, velocity, 0.02) - from - 0.02 * velocity).norm(), 0.002);
  EXPECT_LT((rolledOn(from, velocity, 100) - restingPlace(from, velocity)).norm(), 1e-9);
  // Per cycle of 20 ms the simulator's ball keeps 97.85 % of its speed.
  const Vec2 first = rolledOn(from, velocity, 0.02) - from;
  const Vec2 second = rolledOn(from, velocity, 0.04) - rolledOn(from, velocity, 0.02);
  EXPECT_NEAR(second.norm() / first.norm(), 0.9785, 1e-4);
}

TEST(RollingBall, takesWhatIsHardlySeenToMoveForStill) {
  const Vec2 place(3, 1);
  EXPECT_EQ(restingPlace(place, {0.1, -0.2}), place);
  EXPECT_EQ(meetingPlace({0, 0}, 0.8, place, {0.1, -0.2}), place);
}

TEST(RollingBall, isMetWhereTheRobotIsNoLaterThanTheBall) {
  // It comes straight to the robot: between both.
  const Vec2 coming = meetingPlace({4, 0}, 0.8, {0, 0}, {5, 0});
  EXPECT_GT(coming.x(), 2.5);
  EXPECT_LT(coming.x(), 4);
  // It goes away and is faster: where it rests.
  EXPECT_LT((meetingPlace({-3, 0}, 0.8, {0, 0}, {5, 0}) - restingPlace({0, 0}, {5, 0})).norm(), 0.07);
  // At the robot's feet: there.
  EXPECT_EQ(meetingPlace({0, 0}, 0.8, {0, 0}, {5, 0}), Vec2(0, 0));
}

}  // namespace
