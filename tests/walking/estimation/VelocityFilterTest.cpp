#include "walking/estimation/VelocityFilter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "walking/model/LinearInvertedPendulum.h"

namespace plumbline::walking {
namespace {

constexpr double step = 0.02;

/// A pendulum on its left foot that the filter observes.
struct Watched {
  LinearInvertedPendulum model{0.25};
  WalkState truth;
  VelocityFilter filter;
  Random noise{7};
  double squares = 0, seenSquares = 0;

  explicit Watched(const Vec2& velocity, int particles = 60)
      : filter({.particles = particles, .modelNoise = 3, .footNoise = 0.0008, .seed = 1}) {
    truth.support = Support::left;
    truth.foot[0] = Pose2(-0.01, 0.05);
    truth.velocity = velocity;
  }
  void cycle(double sigma = 0) {
    // The pendulum swings to and fro over the foot: no step is needed.
    truth.foot[0].position.x() = -truth.velocity.x() / 6;
    WalkAction action;
    action.duration = step;
    const WalkState after = model.move(truth, action, step);
    const Vec2 mean = (truth.foot[0].position - after.foot[0].position) / step;
    const Vec2 seen = mean + sigma * Vec2(noise.gaussian(), noise.gaussian());
    filter.update(model, truth, action, step, {.change = {}, .seen = seen});
    truth = after;
    truth.foot[0] = Pose2(-0.01, 0.05);
    squares += (filter.velocity() - truth.velocity).squaredNorm();
    seenSquares += (seen - mean).squaredNorm();
  }
};

TEST(VelocityFilter, findsAVelocityItDidNotGet) {
  Watched watched(Vec2(0.4, 0.1));
  for (int i = 0; i < 8; ++i) watched.cycle();
  EXPECT_NEAR((watched.filter.velocity() - watched.truth.velocity).norm(), 0, 0.03);
}

TEST(VelocityFilter, aPushIsSeenWithinThreeCycles) {
  Watched watched(Vec2(0.2, 0.1));
  watched.filter.reset(Vec2(0.2, 0.1));
  for (int i = 0; i < 10; ++i) watched.cycle();
  watched.truth.velocity += Vec2(0.15, -0.2);
  for (int i = 0; i < 3; ++i) watched.cycle();
  EXPECT_NEAR((watched.filter.velocity() - watched.truth.velocity).norm(), 0, 0.05);
}

/// A robot that stands with this velocity [m/s]: no force changes it, and this is seen of it.
Vec2 update(VelocityFilter& filter, const Vec2& seen) {
  static const LinearInvertedPendulum model(0.25);
  WalkAction action;
  action.duration = step;
  return filter.update(model, {}, action, step, {.change = Vec2(0, 0), .seen = seen});
}

TEST(VelocityFilter, aPushThatTheFeetDoNotFeelIsBelievedWhenItLasts) {
  VelocityFilter filter;
  for (int i = 0; i < 5; ++i) update(filter, Vec2(0, 0));
  // 0.1 m/s in each cycle for 0.1 s: seen, not felt.
  for (int i = 1; i <= 5; ++i) update(filter, Vec2(0.1 * i, 0));
  for (int i = 0; i < 2; ++i) update(filter, Vec2(0.5, 0));
  EXPECT_NEAR(update(filter, Vec2(0.5, 0)).x(), 0.5, 0.03);
}

TEST(VelocityFilter, aFootThatSlidesForACycleIsNoPush) {
  VelocityFilter filter;
  for (int i = 0; i < 5; ++i) update(filter, Vec2(0.2, 0));
  EXPECT_NEAR(update(filter, Vec2(0.4, 0.1)).x(), 0.2, 0.03);
  EXPECT_NEAR(update(filter, Vec2(0.2, 0)).x(), 0.2, 0.03);
}

TEST(VelocityFilter, knowsMoreThanTheFootShows) {
  // A foot whose movement is seen badly: the model makes up for it.
  Watched watched(Vec2(0.2, 0), 500);
  watched.filter = VelocityFilter({.particles = 500, .modelNoise = 1, .footNoise = 0.002, .seed = 3});
  watched.filter.reset(Vec2(0.2, 0));
  for (int i = 0; i < 12; ++i) watched.cycle(0.1);
  EXPECT_LT(watched.squares, 0.5 * watched.seenSquares);
}

TEST(VelocityFilter, trustsTheFootAsMuchInHalfTheCycle) {
  // A foot's place is as sure as before, so its velocity half as well; the model errs half as much.
  double rms[2];
  for (const int share : {1, 2}) {
    const double cycle = step / share;
    const LinearInvertedPendulum model(0.25);
    VelocityFilter filter({.particles = 2000});
    Random noise(11);
    WalkState still;
    still.support = Support::left;
    WalkAction action;
    action.duration = cycle;
    double squares = 0;
    for (int i = 0; i < 400 * share; ++i) {
      const Vec2 seen = 0.0005 / cycle * Vec2(noise.gaussian(), noise.gaussian());
      squares += filter.update(model, still, action, cycle, {.change = {}, .seen = seen}).squaredNorm();
    }
    rms[share - 1] = std::sqrt(squares / (400 * share));
  }
  EXPECT_NEAR(rms[1] / rms[0], 1, 0.25);
}

TEST(VelocityFilter, aVelocityThatIsSetIsKnownToATenthOfAMetreASecond) {
  // A foot that shows the velocity as well as that, with a deviation of 0.1 m/s: halfway between the two.
  VelocityFilter filter({.particles = 20000, .modelNoise = 0, .footNoise = 0.002});
  WalkState still;
  still.support = Support::left;
  WalkAction action;
  action.duration = step;
  const LinearInvertedPendulum model(0.25);
  EXPECT_NEAR(filter.update(model, still, action, step, {.change = {}, .seen = Vec2(0.1, 0)}).x(), 0.05,
              0.004);
}

TEST(VelocityFilter, whatNoParticleExplainsBeginsAnew) {
  Watched watched(Vec2(0.2, 0));
  WalkAction action;
  action.duration = step;
  EXPECT_EQ(
      watched.filter.update(watched.model, watched.truth, action, step, {.change = {}, .seen = Vec2(9, 0)}),
      Vec2(9, 0));
}

TEST(VelocityFilter, sameCallsSameAnswers) {
  Watched a(Vec2(0.2, 0)), b(Vec2(0.2, 0));
  b.cycle(0.05);
  b = Watched(Vec2(0.2, 0));
  for (int i = 0; i < 20; ++i) {
    a.cycle(0.02);
    b.cycle(0.02);
  }
  EXPECT_EQ(a.filter.velocity(), b.filter.velocity());
}

}  // namespace
}  // namespace plumbline::walking
