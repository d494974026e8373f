#include "gap/inference/Likelihood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "math/Random.h"

namespace plumbline::gap {

namespace {

std::vector<double> gaussians(std::size_t n, double sigma) {
  Random random(5);
  std::vector<double> values;
  for (std::size_t k = 0; k < n; ++k) values.push_back(sigma * random.gaussian());
  return values;
}

}  // namespace

TEST(Likelihood, densityOfOneResidualIsStudents) {
  // t with four degrees of freedom at 0: 3/8; at scale s: 3/(8 s).
  EXPECT_NEAR(logDensity({0.0}, 2), std::log(3.0 / 16), 1e-12);
  // At x = 2: 3/8 * (1 + 1)^(-5/2).
  EXPECT_NEAR(logDensity({2.0}, 1), std::log(3.0 / 8) - 2.5 * std::log(2.0), 1e-12);
}

TEST(Likelihood, weightIsTheSlopeOfTheDensity) {
  constexpr double r = 0.7, s = 0.3, h = 1e-6;
  const double slope = (logDensity({r + h}, s) - logDensity({r - h}, s)) / (2 * h);
  EXPECT_NEAR(-slope, weightOf(r, s) * r, 1e-6);
}

TEST(Likelihood, scaleIsTheLikeliestOne) {
  const std::vector<double> values = gaussians(2000, 3);
  const double scale = likeliestScale(values, 1e-9);
  EXPECT_GT(logDensity(values, scale), logDensity(values, 1.02 * scale));
  EXPECT_GT(logDensity(values, scale), logDensity(values, scale / 1.02));
}

TEST(Likelihood, scaleStaysAtTheNoiseWhereNothingElseIsLeft) {
  EXPECT_EQ(likeliestScale(gaussians(500, 0.5), 1), 1);
}

TEST(Likelihood, aMeanNearZeroByChanceSaysNoMoreThanItsVariationAllows) {
  // Four independent samples of 0.1: their mean is known to 0.05, however near to zero it comes.
  EXPECT_DOUBLE_EQ(scaleOfMean(0.001, 1e-4, 0.1, 4), 0.05);
  EXPECT_DOUBLE_EQ(scaleOfMean(-0.2, 1e-4, 0.1, 4), 0.2);
  EXPECT_DOUBLE_EQ(scaleOfMean(0.001, 0.07, 0.1, 4), 0.07);
  EXPECT_DOUBLE_EQ(scaleOfMean(0, 0, 0.1, 0.3), 0.1) << "there is one sample at least";
  std::vector<double> values = gaussians(400, 0.1);
  const double share = 0.01;  // four independent ones
  Split parts = split(values);
  parts.mean = 0.01;
  const double near = stretchDensity(parts, 1e-6, share);
  parts.mean = 0.001;
  EXPECT_NEAR(stretchDensity(parts, 1e-6, share), near, 0.1);
  parts.mean = 0.5;
  EXPECT_LT(stretchDensity(parts, 1e-6, share), near - 2);
}

TEST(Likelihood, outliersHardlyMoveTheScale) {
  std::vector<double> values = gaussians(500, 1);
  const double clean = likeliestScale(values, 0);
  for (std::size_t k = 0; k < 10; ++k) values[50 * k] = 100;
  EXPECT_LT(likeliestScale(values, 0), 1.3 * clean);
}

TEST(Likelihood, theMeanOfAStretchCountsOnceHoweverLongItIs) {
  // Half the mean is worth log 2, in 500 samples as in 5000.
  for (const std::size_t n : {500, 5000}) {
    std::vector<double> all = gaussians(n, 1), half = all;
    for (double& r : all) r += 40;
    for (double& r : half) r += 20;
    EXPECT_NEAR(stretchDensity(split(half), 0.1, 1) - stretchDensity(split(all), 0.1, 1), std::log(2.0),
                0.01);
  }
}

TEST(Likelihood, aConstantDoesNotMakeTheRestLookSlow) {
  std::vector<double> values = gaussians(4000, 1);
  for (double& r : values) r += 100;
  EXPECT_LT(correlationTime(values), 1.3);
}

TEST(Likelihood, independentResidualsCountOneByOne) { EXPECT_LT(correlationTime(gaussians(4000, 1)), 1.3); }

TEST(Likelihood, correlationTimeOfAnAutoregressiveSeriesIsItsFormula) {
  constexpr double a = 0.8;  // (1 + a) / (1 - a) = 9
  std::vector<double> values = gaussians(40000, 1);
  for (std::size_t k = 1; k < values.size(); ++k) values[k] += a * values[k - 1];
  EXPECT_NEAR(correlationTime(values), 9, 1.5);
}

TEST(Likelihood, sumsAreThoseOfOneValueAfterTheOther) {
  // Answers hang on the last bit.
  for (const std::size_t n : {5, 18, 19, 401}) {
    std::vector<double> values = gaussians(n, 1);
    for (std::size_t k = 1; k < n; ++k) values[k] += 0.9 * values[k - 1];
    const std::vector<double> x = split(values).about;
    const auto covariance = [&](std::size_t lag) {
      double sum = 0;
      for (std::size_t k = lag; k < n; ++k) sum += x[k] * x[k - lag];
      return sum;
    };
    double times = 0;
    for (std::size_t lag = 1; lag + 1 < n / 2; lag += 2) {
      const double pair = (covariance(lag) + covariance(lag + 1)) / covariance(0);
      if (pair <= 0) break;
      times += pair;
    }
    EXPECT_EQ(correlationTime(values), std::max(1.0, 1 + 2 * times)) << n;

    values[n / 2] = std::nan("");
    double square = 0, count = 0;
    for (const double r : values)
      if (std::isfinite(r)) square += r * r, ++count;
    square /= count;
    for (int round = 0; round < 60; ++round) {
      double sum = 0;
      for (const double r : values)
        if (std::isfinite(r)) sum += r * r / (tailFreedom + r * r / square);
      const double next = (tailFreedom + 1) * sum / count;
      const bool done = std::abs(next - square) <= 1e-4 * square;
      square = next;
      if (done) break;
    }
    EXPECT_EQ(likeliestScale(values, 0), std::sqrt(square)) << n;
  }
}

TEST(Likelihood, aScaleAtTheNoiseIsKnownAndBeyondItCountsByItsShareOfTheVariance) {
  EXPECT_DOUBLE_EQ(timeOfScale(9, 0.1, 0.1), 1);
  EXPECT_DOUBLE_EQ(timeOfScale(9, 0.2, 0.1), 7);  // three quarters of the variance are beyond the noise
  EXPECT_NEAR(timeOfScale(9, 10, 0.1), 9, 1e-3);
}

}  // namespace plumbline::gap
