#include "gap/inference/ResidualSeries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "gap/inference/Likelihood.h"
#include "math/Random.h"

namespace plumbline::gap {

namespace {

std::vector<double> walk(std::size_t n) {
  Random random(11);
  std::vector<double> values{0};
  while (values.size() < n) values.push_back(0.8 * values.back() + 1e-3 * random.gaussian());
  values[n / 2] = std::numeric_limits<double>::quiet_NaN();
  return values;
}

}  // namespace

TEST(ResidualSeries, aStretchsDensityIsTheLikelihoods) {
  const std::vector<double> values = walk(400);
  const ResidualSeries series(values);
  const std::vector<double> part(values.begin() + 100, values.begin() + 300);
  EXPECT_DOUBLE_EQ(series.fitOf(100, 300, 1e-4).density(0.3), stretchDensity(split(part), 1e-4, 0.3));
  EXPECT_DOUBLE_EQ(series.correlationOf(100, 300), correlationTime(part));
}

TEST(ResidualSeries, whatWasWorkedOutBeforeIsNotMistakenForAnother) {
  const ResidualSeries series(walk(400)), fresh(walk(400));
  const StretchFit quiet = series.fitOf(0, 200, 1e-6), loud = series.fitOf(0, 200, 1.0);
  EXPECT_GT(loud.scale, 100 * quiet.scale);
  EXPECT_EQ(loud.scale, 1.0);
  EXPECT_NE(series.fitOf(200, 400, 1e-6).about, quiet.about);
  EXPECT_EQ(series.fitOf(0, 200, 1e-6).about, quiet.about);
  EXPECT_EQ(fresh.fitOf(0, 200, 1e-6).about, quiet.about);
}

TEST(ResidualSeries, aStretchEndsWhereTheSeriesDoes) {
  const ResidualSeries series({1, 2, 3});
  EXPECT_EQ(series.stretch(1, 9), (std::vector<double>{2, 3}));
  EXPECT_TRUE(series.stretch(3, 9).empty());
}

}  // namespace plumbline::gap
