#include "training/tasks/BallRoll.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::training {
namespace {

simulation::BodyState ballWith(const Vec3& velocity) {
  return {translation(-10, 5, 0.042), velocity, Vec3::Zero()};
}

TEST(BallRoll, restsWhereAWorldThatIsSteppedLongEnoughHasIt) {
  BallRoll roll;
  const BallRoll::Rest rest = roll.roll(ballWith(Vec3(3, 1, 0)));
  const auto world = simulation::makeWorld();
  world->setBall(ballWith(Vec3(3, 1, 0)));
  for (int i = 0; i < 2000; ++i) world->step();
  EXPECT_LT((rest.place - world->ball().pose.translation().head<2>()).norm(), 0.1);
  EXPECT_GT((rest.place - Vec2(-10, 5)).norm(), 1);
  EXPECT_NEAR(rest.height, 0.042, 0.01);
}

TEST(BallRoll, tellsHowHighItFlew) {
  BallRoll roll;
  // Without the air's drag it would be 16 / (2 * 9.81) = 0.82 m.
  const double risen = roll.roll(ballWith(Vec3(4, 0, 4))).height - 0.042;
  EXPECT_GT(risen, 0.6);
  EXPECT_LT(risen, 16 / (2 * 9.81));
}

TEST(BallRoll, aRollDependsOnItsBallAlone) {
  BallRoll used, fresh;
  used.roll(ballWith(Vec3(5, -2, 3)));
  EXPECT_EQ(used.roll(ballWith(Vec3(2, 0, 1))).place, fresh.roll(ballWith(Vec3(2, 0, 1))).place);
}

TEST(BallRoll, showsTheWay) {
  BallRoll roll;
  double highest = 0, last = -10;
  bool forward = true;
  const BallRoll::Rest rest = roll.roll(ballWith(Vec3(4, 0, 4)), [&](const Vec3& ball) {
    highest = std::max(highest, ball.z());
    forward = forward && ball.x() >= last;
    last = ball.x();
  });
  EXPECT_DOUBLE_EQ(highest, rest.height);
  EXPECT_TRUE(forward);
  EXPECT_NEAR(last, rest.place.x(), 1e-3);
}

TEST(BallRoll, rollsOnTheEngineThatIsNamed) {
  BallRoll ode, bullet("bullet");
  const Vec2 one = ode.roll(ballWith(Vec3(4, 0, 2))).place,
             other = bullet.roll(ballWith(Vec3(4, 0, 2))).place;
  EXPECT_NE(one.x(), other.x());
  EXPECT_NEAR(one.x(), other.x(), 1.5);
}

}  // namespace
}  // namespace plumbline::training
