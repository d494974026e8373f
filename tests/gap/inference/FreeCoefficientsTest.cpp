#include "gap/inference/FreeCoefficients.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

TEST(FreeCoefficients, aCellIsItsMeanAndWhatVariesAboutItOverTheNoise) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}, 2));
  const Replayer replayer(arm, groups, 1);
  const FreeCoefficients free(replayer);
  ASSERT_EQ(free.cells().size(), 2 * groups.cells().size());
  const Explanation causes{causeOf(arm, "servo_gain", "elbow", 0.6)};
  const Coefficients of = free.coefficients(causes);
  const Residuals residuals = replayer.residuals(causes);
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    const Cell& cell = groups.cells()[c];
    const std::vector<double> r = residualsOf(cell, residuals);
    const double mean = std::accumulate(r.begin(), r.end(), 0.0) / static_cast<double>(r.size()) / cell.noise;
    ASSERT_EQ(of[2 * c].size(), 1);
    EXPECT_NEAR(of[2 * c](0, 0), mean, 1e-9);
    ASSERT_EQ(of[2 * c + 1].cols(), static_cast<Eigen::Index>(r.size()));
    EXPECT_NEAR(of[2 * c + 1](0, 7), r[7] / cell.noise - mean, 1e-9);
  }
}

TEST(FreeCoefficients, ofALongCellSomeSamplesStandForAll) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}, 12));
  const Replayer replayer(arm, groups, 1);
  FreeCoefficients free(replayer);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    const CoefficientCell& cell = free.cells()[2 * c + 1];
    EXPECT_LE(cell.columns.size(), 250U);
    const auto all = static_cast<double>(groups.cells()[c].to - groups.cells()[c].from);
    EXPECT_NEAR(cell.share * static_cast<double>(cell.columns.size()), shares[c] * all, 1e-9);
    EXPECT_EQ(free.cells()[2 * c].share, 1) << "a mean was seen once";
  }
}

TEST(FreeCoefficients, countForWhatTheyAreWorthWithASet) {
  const Mechanism arm = twoJointArm();
  const Explanation truth{causeOf(arm, "coulomb_friction", "shoulder", 0.15)};
  const Groups groups(recordings(truth, 4));
  const Replayer replayer(arm, groups, 1);
  FreeCoefficients free(replayer);
  const double before = free.cells()[1].share;
  EXPECT_TRUE(free.updateColumnShares(truth));
  EXPECT_GT(free.cells()[1].share, before) << "what friction left was slow";
}

}  // namespace plumbline::gap
