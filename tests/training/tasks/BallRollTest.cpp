#include "training/tasks/BallRoll.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::training {
namespace {

simulation::BodyState ballWith(const Vec3& velocity) {
  return {translation(-10, 5, 0.042), velocity, Vec3::Zero()};
}

std::function<void(const Vec3&)> highestInto(double& highest) {
  return [&](const Vec3& ball) { highest = std::max(highest, ball.z()); };
}

TEST(BallRoll, restsWhereAWorldThatIsSteppedLongEnoughHasIt) {
  BallRoll roll;
  double highest = 0;
  const Vec2 rest = roll.roll(ballWith(Vec3(3, 1, 0)), highestInto(highest));
  const auto world = simulation::makeWorld();
  world->setBall(ballWith(Vec3(3, 1, 0)));
  for (int i = 0; i < 2000; ++i) world->step();
  EXPECT_LT((rest - world->ball().pose.translation().head<2>()).norm(), 0.1);
  EXPECT_GT((rest - Vec2(-10, 5)).norm(), 1);
  EXPECT_NEAR(highest, 0.042, 0.01);
}

TEST(BallRoll, showsHowHighItFlies) {
  BallRoll roll;
  double highest = 0;
  roll.roll(ballWith(Vec3(4, 0, 4)), highestInto(highest));
  // Without the air's drag it would be 16 / (2 * 9.81) = 0.82 m.
  const double risen = highest - 0.042;
  EXPECT_GT(risen, 0.6);
  EXPECT_LT(risen, 16 / (2 * 9.81));
}

TEST(BallRoll, aRollDependsOnItsBallAlone) {
  BallRoll used, fresh;
  used.roll(ballWith(Vec3(5, -2, 3)));
  EXPECT_EQ(used.roll(ballWith(Vec3(2, 0, 1))), fresh.roll(ballWith(Vec3(2, 0, 1))));
}

TEST(BallRoll, showsTheWay) {
  BallRoll roll;
  double last = -10;
  bool forward = true;
  const Vec2 rest = roll.roll(ballWith(Vec3(4, 0, 4)), [&](const Vec3& ball) {
    forward = forward && ball.x() >= last;
    last = ball.x();
  });
  EXPECT_TRUE(forward);
  EXPECT_NEAR(last, rest.x(), 1e-3);
}

TEST(BallRoll, rollsOnTheEngineThatIsNamed) {
  BallRoll ode, bullet("bullet");
  const Vec2 one = ode.roll(ballWith(Vec3(4, 0, 2))), other = bullet.roll(ballWith(Vec3(4, 0, 2)));
  EXPECT_NE(one.x(), other.x());
  EXPECT_NEAR(one.x(), other.x(), 1.5);
}

}  // namespace
}  // namespace plumbline::training
