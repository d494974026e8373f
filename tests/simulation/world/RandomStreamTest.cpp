#include "simulation/world/RandomStream.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::simulation {
namespace {

TEST(RandomStream, sameSeedSameNumbersEverywhere) {
  RandomStream a(42, 1), b(42, 1);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.normal(), b.normal());
  RandomStream c(42, 1);
  EXPECT_DOUBLE_EQ(c.uniform(0, 1), 0.83798903310489214);
}

TEST(RandomStream, streamsAndSeedsDiffer) {
  RandomStream a(42, 1), b(42, 2), c(43, 1), d(42ull + (1ull << 32), 1);
  const double x = a.uniform(0, 1);
  EXPECT_NE(x, b.uniform(0, 1));
  EXPECT_NE(x, c.uniform(0, 1));
  EXPECT_NE(x, d.uniform(0, 1));
}

TEST(RandomStream, momentsOfTheNormalDistribution) {
  RandomStream random(3);
  const int n = 200000;
  double sum = 0, square = 0, fourth = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / n, 0, 0.01);
  EXPECT_NEAR(square / n, 1, 0.015);
  EXPECT_NEAR(fourth / n, 3, 0.1);
}

TEST(RandomStream, uniformStaysInside) {
  RandomStream random(4);
  double low = 1, high = 0, sum = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform(-0.05, 0.05);
    low = std::min(low, x);
    high = std::max(high, x);
    sum += x;
  }
  EXPECT_GE(low, -0.05);
  EXPECT_LT(low, -0.0499);
  EXPECT_LT(high, 0.05);
  EXPECT_GT(high, 0.0499);
  EXPECT_NEAR(sum / 100000, 0, 5e-4);
}

}  // namespace
}  // namespace plumbline::simulation
