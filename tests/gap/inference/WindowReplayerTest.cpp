#include "gap/inference/WindowReplayer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

namespace {

/// Root mean square of the coefficients: 1 under a perfect model.
double sizeOf(const Coefficients& of) {
  double squares = 0, count = 0;
  for (const Eigen::MatrixXd& columns : of)
    squares += columns.squaredNorm(), count += static_cast<double>(columns.size());
  return std::sqrt(squares / count);
}

}  // namespace

TEST(CosineCoefficients, keepTheNormAndTheMean) {
  std::vector<double> values;
  double squares = 0;
  for (int k = 0; k < 16; ++k) {
    values.push_back(std::sin(0.7 * k) + 2);
    squares += values.back() * values.back();
  }
  const ResidualSeries series(values);
  const Eigen::VectorXd all = CosineBasis(16, 99).coefficients(series, 0);
  ASSERT_EQ(all.size(), 16);
  EXPECT_NEAR(all.squaredNorm(), squares, 1e-9);
  const ResidualSeries constant(std::vector<double>(9, 3.0));
  const Eigen::VectorXd few = CosineBasis(9, 4).coefficients(constant, 0);
  ASSERT_EQ(few.size(), 4);
  EXPECT_NEAR(few[0], 9, 1e-9);  // sqrt(9) times 3
  EXPECT_NEAR(few.tail(3).norm(), 0, 1e-9);
}

TEST(CosineCoefficients, areSumsInTheOrderOfTheSamples) {
  // Answers hang on the last bit.
  std::vector<double> values;
  for (int k = 0; k < 40; ++k) values.push_back(std::sin(0.7 * k * k));
  const ResidualSeries series(values);
  for (const std::size_t count : {1, 2, 5, 12, 15}) {
    const Eigen::VectorXd all = CosineBasis(30, count).coefficients(series, 7);
    ASSERT_EQ(all.size(), static_cast<Eigen::Index>(count));
    for (std::size_t j = 0; j < count; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < 30; ++k)
        sum += values[7 + k] *
               std::cos(std::numbers::pi * static_cast<double>(j) * (static_cast<double>(k) + 0.5) / 30);
      EXPECT_EQ(all[static_cast<Eigen::Index>(j)], sum * std::sqrt((j == 0 ? 1.0 : 2.0) / 30)) << j;
    }
  }
}

TEST(WindowReplayer, theTruthLeavesWhiteCoefficientsAndAnotherModelLarger) {
  const Mechanism arm = twoJointArm();
  const Explanation truth{causeOf(arm, "coulomb_friction", "shoulder", 0.15)};
  const Groups groups(recordings(truth));
  const WindowReplayer replayer(arm, groups, 1);
  EXPECT_EQ(replayer.groups().count(), 3U);
  EXPECT_EQ(replayer.cells().size(), 6U);  // two positions in three groups
  const double left = sizeOf(replayer.coefficients(truth));
  EXPECT_LT(left, 1.3);
  EXPECT_GT(left, 0.5);
  EXPECT_GT(sizeOf(replayer.coefficients({})), 2 * left);
}

TEST(WindowReplayer, withoutAGroupTheOthersKeepTheirCoefficients) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}, 2));
  const WindowReplayer replayer(arm, groups, 1), two(replayer, 1);
  EXPECT_EQ(two.groups().count(), 2U);
  const Explanation causes{causeOf(arm, "servo_gain", "elbow", 0.8)};
  const Coefficients all = replayer.coefficients(causes), some = two.coefficients(causes);
  std::vector<Eigen::MatrixXd> expected;
  for (std::size_t c = 0; c < all.size(); ++c)
    if (replayer.cells()[c].group != 1) expected.push_back(all[c]);
  EXPECT_EQ(some, expected);
}

}  // namespace plumbline::gap
