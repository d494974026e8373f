#include "walking/estimation/Disturbance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::walking {
namespace {

constexpr double dt = 0.02, height = 0.25;
const double rate = std::sqrt(9.81 / height);

class DisturbanceTest : public testing::Test {
protected:
  DisturbanceTest() {
    p.observation.biasWindow = 1;
    p.recovery.from = 0.04;
    p.recovery.full = 0.08;
    p.recovery.fadeTime = 0.5;
    p.step.duration = 0.1;
    planned.foot = {Pose2(0, 0.05), Pose2(0, -0.05)};
    planned.support = Support::left;
  }
  void cycle(const Vec2& foot, const Vec2& velocity, double phase = 0.5) {
    WalkState observed = planned;
    for (Pose2& f : observed.foot) f.position += foot;
    observed.velocity += velocity;
    disturbance.update(planned, observed, phase, height, p, dt);
  }

  WalkParameters p;
  WalkState planned;
  Disturbance disturbance;
};

TEST_F(DisturbanceTest, tellsHowFarTheCapturePointIsOff) {
  p.observation.biasWindow = 0;
  cycle(Vec2(-0.01, 0.02), Vec2(0.1, -0.2));
  EXPECT_NEAR(disturbance.capturePoint().x(), 0.01 + 0.1 / rate, 1e-12);
  EXPECT_NEAR(disturbance.capturePoint().y(), -0.02 - 0.2 / rate, 1e-12);
  EXPECT_EQ(disturbance.velocity(), Vec2(0.1, -0.2));
}

TEST_F(DisturbanceTest, whatComesInEveryStepIsUsual) {
  for (int i = 0; i < 100; ++i) {
    cycle(Vec2(0, 0), Vec2(0.1, 0), 0.2);
    cycle(Vec2(0, 0), Vec2(-0.1, 0), 0.8);
  }
  cycle(Vec2(0, 0), Vec2(0.1, 0), 0.2);
  EXPECT_NEAR(disturbance.velocity().x(), 0, 1e-6);
  cycle(Vec2(0, 0), Vec2(0.1, 0), 0.8);
  EXPECT_NEAR(disturbance.velocity().x(), 0.2, 1e-6);
  // The other foot has its own.
  planned.support = Support::right;
  cycle(Vec2(0, 0), Vec2(0.1, 0), 0.2);
  EXPECT_NEAR(disturbance.velocity().x(), 0.1, 1e-6);
}

TEST_F(DisturbanceTest, aPushIsRecoveredFromForAWhileAndNotLearnt) {
  cycle(Vec2(0, 0), Vec2(0.06 * rate, 0));
  EXPECT_NEAR(disturbance.share(), 0.5, 1e-9);
  for (int i = 0; i < 10; ++i) cycle(Vec2(0, 0), Vec2(0.2 * rate, 0));
  EXPECT_EQ(disturbance.share(), 1);
  EXPECT_GT(disturbance.velocity().x(), 0.17 * rate);
  cycle(Vec2(0, 0), Vec2(0, 0));
  EXPECT_NEAR(disturbance.share(), 1 - dt / 0.5, 1e-9);
  for (int i = 0; i < 25; ++i) cycle(Vec2(0, 0), Vec2(0, 0));
  EXPECT_EQ(disturbance.share(), 0);
}

TEST_F(DisturbanceTest, withoutBoundsItNeverRecovers) {
  p.recovery.full = 0;
  cycle(Vec2(0, 0), Vec2(1, 1));
  EXPECT_EQ(disturbance.share(), 0);
}

}  // namespace
}  // namespace plumbline::walking
