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

// A push has to last to be taken for usual: what is far off is learnt no faster than two centimetres.
TEST_F(DisturbanceTest, aFootFarOffIsLearntNoFasterThanOneTwoCentimetresOff) {
  p.recovery.full = 0;
  const auto learntOf = [&](double offset) {
    disturbance.reset();
    cycle(Vec2(offset, 0), Vec2::Zero());
    cycle(Vec2(offset, 0), Vec2::Zero());
    return offset - disturbance.foot().x();
  };
  EXPECT_GT(learntOf(0.018), 1.1 * learntOf(0.016));
  EXPECT_NEAR(learntOf(0.1), learntOf(0.02), 1e-12);
  EXPECT_NEAR(learntOf(0.02), 0.2 * 0.02, 1e-12) << "two steps of 0.1 s of a window of 1 s";
}

// An error that changes within a step is usual, too: each eighth of it has its own.
TEST_F(DisturbanceTest, whatChangesFromEighthToEighthOfAStepIsUsual) {
  const auto speed = [](int part) { return Vec2(part % 2 == 0 ? 0.05 : -0.05, 0); };
  for (int i = 0; i < 800; ++i) cycle(Vec2::Zero(), speed(i), (i % 8 + 0.5) / 8);
  for (int i = 0; i < 8; ++i) {
    cycle(Vec2::Zero(), speed(i), (i + 0.5) / 8);
    EXPECT_NEAR(disturbance.velocity().x(), 0, 1e-6) << i;
  }
}

TEST_F(DisturbanceTest, withoutBoundsItNeverRecovers) {
  p.recovery.full = 0;
  cycle(Vec2(0, 0), Vec2(1, 1));
  EXPECT_EQ(disturbance.share(), 0);
}

}  // namespace
}  // namespace plumbline::walking
