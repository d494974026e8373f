#include "modules/modeling/ball/BallFilter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/Random.h"

using namespace plumbline;

namespace {

constexpr double period = 0.02;

Mat2 deviation(double s) { return s * s * Mat2::Identity(); }
Vec2 noise(Random& random, double s) {
  const double x = random.gaussian(), y = random.gaussian();
  return {s * x, s * y};
}

/// The league's rolling ball: its speed keeps 0.9785 per cycle.
struct RollingBall {
  Vec2 position, velocity;
  void step() {
    velocity *= 0.9785;
    position += period * velocity;
  }
};

TEST(BallFilter, convergesOnARollingBall) {
  BallFilter filter;
  Random random(4);
  RollingBall ball{{1, 0.5}, {2, -1}};
  for (int i = 0; i < 50; ++i) {
    if (i > 0) ball.step();
    filter.predict(period, false);
    if (i % 3 == 0) filter.update(ball.position + noise(random, 0.005), deviation(0.005));
  }
  EXPECT_LT((filter.position() - ball.position).norm(), 0.01);
  EXPECT_LT((filter.velocity() - ball.velocity).norm(), 0.08);
  EXPECT_LT(filter.deviation(), 0.005);
}

TEST(BallFilter, foretellsWhereTheBallStops) {
  BallFilter filter;
  RollingBall ball{{0, 0}, {3, 0}};
  for (int i = 0; i < 60; ++i) {
    if (i > 0) ball.step();
    filter.predict(period, false);
    if (i % 3 == 0) filter.update(ball.position, deviation(0.003));
  }
  for (int i = 0; i < 500; ++i) {
    ball.step();
    filter.predict(period, false);
  }
  EXPECT_LT((filter.position() - ball.position).norm(), 0.02);
  EXPECT_LT(filter.velocity().norm(), 0.001);
}

TEST(BallFilter, aRestingBallGetsSharperThanOnePercept) {
  BallFilter filter;
  Random random(5);
  double squares = 0;
  int count = 0;
  for (int i = 0; i < 3000; ++i) {
    filter.predict(period, false);
    if (i % 3 == 0) filter.update(Vec2(3, 1) + noise(random, 0.02), deviation(0.02));
    if (i > 300) squares += (filter.position() - Vec2(3, 1)).squaredNorm(), ++count;
  }
  EXPECT_LT(std::sqrt(squares / count / 2), 0.01);
}

TEST(BallFilter, oneWildPerceptWaitsForASecond) {
  BallFilter filter;
  for (int i = 0; i < 60; ++i) {
    filter.predict(period, false);
    if (i % 3 == 0) {
      EXPECT_TRUE(filter.update(Vec2(1, 0), deviation(0.005)));
    }
  }
  EXPECT_FALSE(filter.update(Vec2(4, 2), deviation(0.005)));
  EXPECT_LT((filter.position() - Vec2(1, 0)).norm(), 0.01);
  filter.predict(3 * period, false);
  EXPECT_TRUE(filter.update(Vec2(1, 0), deviation(0.005)));
}

TEST(BallFilter, aKickedBallIsFoundWithTheSecondPercept) {
  BallFilter filter;
  RollingBall ball{{0.2, 0}, {0, 0}};
  for (int i = 0; i < 60; ++i) {
    filter.predict(period, false);
    if (i % 3 == 0) filter.update(ball.position, deviation(0.005));
  }
  ball.velocity = {6, 1};
  for (int i = 0; i < 6; ++i) {
    ball.step();
    filter.predict(period, false);
    if (i % 3 == 2) filter.update(ball.position, deviation(0.005));
  }
  EXPECT_LT((filter.position() - ball.position).norm(), 0.02);
  EXPECT_LT((filter.velocity() - ball.velocity).norm(), 0.5);
}

TEST(BallFilter, deviationGrowsWhileUnseen) {
  BallFilter filter;
  EXPECT_FALSE(filter.started());
  filter.update(Vec2(1, 0), deviation(0.01));
  EXPECT_TRUE(filter.started());
  const double before = filter.deviation();
  for (int i = 0; i < 100; ++i) filter.predict(period, false, 0.001);
  EXPECT_GT(filter.deviation(), 10 * before);
  filter.reset();
  EXPECT_FALSE(filter.started());
}

}  // namespace
