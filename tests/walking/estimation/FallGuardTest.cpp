#include "walking/estimation/FallGuard.h"

#include <gtest/gtest.h>

namespace plumbline::walking {
namespace {

constexpr FallGuardParameters limits{.roll = 0.4, .pitch = 0.5, .lead = 0.16, .patience = 0.03};
constexpr double cycle = 0.01;

TEST(FallGuard, isOffWithoutLimits) {
  FallGuard guard;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(guard.update(Vec2(1.5, 1.5), Vec2(5, 5), cycle, {}));
}

TEST(FallGuard, knowsATopplingPendulumBeforeItIsLow) {
  // A body that tips over its edge: angle'' = g/h angle.
  FallGuard guard;
  double angle = 0.05, rate = 0.9;
  for (int i = 0; i < 200; ++i) {
    if (guard.update(Vec2(0, angle), Vec2(0, rate), cycle, limits)) break;
    rate += 9.81 / 0.26 * angle * cycle;
    angle += rate * cycle;
  }
  EXPECT_TRUE(guard.falling());
  EXPECT_LT(angle, 0.35) << "cos 0.35 = 0.94 of the height is left";
}

TEST(FallGuard, takesASwayForNoFall) {
  FallGuard guard;
  for (int i = 0; i < 500; ++i) {
    const double t = i * cycle;
    EXPECT_FALSE(
        guard.update(Vec2(0.1 * std::sin(12 * t), 0), Vec2(1.2 * std::cos(12 * t), 0), cycle, limits));
  }
}

TEST(FallGuard, waitsForAFewCycles) {
  FallGuard guard;
  EXPECT_FALSE(guard.update(Vec2(0.6, 0), Vec2::Zero(), cycle, limits));
  EXPECT_FALSE(guard.update(Vec2(0.6, 0), Vec2::Zero(), cycle, limits));
  EXPECT_TRUE(guard.update(Vec2(0.6, 0), Vec2::Zero(), cycle, limits));
}

TEST(FallGuard, aFastReturnToUprightIsNoFall) {
  FallGuard guard;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(guard.update(Vec2(0.3, 0), Vec2(-5, 0), cycle, limits));
}

TEST(FallGuard, endsWhenUprightAndAtRestForHalfASecond) {
  FallGuard guard;
  for (int i = 0; i < 5; ++i) guard.update(Vec2(0, 0.8), Vec2::Zero(), cycle, limits);
  ASSERT_TRUE(guard.falling());
  for (int i = 0; i < 49; ++i) EXPECT_TRUE(guard.update(Vec2::Zero(), Vec2::Zero(), cycle, limits));
  for (int i = 0; i < 3; ++i) guard.update(Vec2::Zero(), Vec2::Zero(), cycle, limits);
  EXPECT_FALSE(guard.falling());
}

TEST(FallGuard, doesNotEndWhileTheRobotLeansOrTurns) {
  const auto ends = [](const Vec2& angles, const Vec2& rates) {
    FallGuard guard;
    for (int i = 0; i < 5; ++i) guard.update(Vec2(0, 0.8), Vec2::Zero(), cycle, limits);
    for (int i = 0; i < 100; ++i) guard.update(angles, rates, cycle, limits);
    return !guard.falling();
  };
  EXPECT_TRUE(ends(Vec2(0, 0.18), Vec2::Zero()));
  EXPECT_FALSE(ends(Vec2(0, -0.23), Vec2::Zero()));
  EXPECT_FALSE(ends(Vec2(0.17, 0.17), Vec2::Zero()));
  EXPECT_TRUE(ends(Vec2::Zero(), Vec2(0.27, 0)));
  EXPECT_FALSE(ends(Vec2::Zero(), Vec2(-0.35, 0)));
}

}  // namespace
}  // namespace plumbline::walking
