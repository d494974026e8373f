#include "gap/inference/LinearResiduals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/Random.h"

namespace plumbline::gap {

namespace {

/// Three groups of one channel, forty windows of two coefficients each, noise 1; three kinds of which each
/// moves the coefficients in its own way.
struct LinearResidualsTest : testing::Test {
  LinearResidualsTest() {
    Random random(5);
    const auto drawn = [&] {
      Eigen::MatrixXd columns(2, 40);
      for (double& value : columns.reshaped()) value = random.gaussian();
      return columns;
    };
    kinds.resize(3);
    for (CauseKind& kind : kinds) kind.lower = -8, kind.upper = 8;
    slopes.resize(kinds.size());
    for (std::size_t g = 0; g < 3; ++g) {
      CoefficientCell cell;
      cell.group = g;
      cell.columns.resize(40);
      cells.push_back(cell);
      residuals.push_back(drawn());
      for (Coefficients& slope : slopes) slope.push_back(2 * drawn());
    }
  }

  /// Where the truth is x: the residuals at strengths of zero are noise less what x would add.
  LinearResiduals linear(const Eigen::Vector3d& x) const {
    Coefficients off = residuals;
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (std::size_t k = 0; k < kinds.size(); ++k) off[c] -= x[static_cast<Eigen::Index>(k)] * slopes[k][c];
    return LinearResiduals(cells, 3, kinds, {}, off, slopes);
  }

  std::vector<CoefficientCell> cells;
  std::vector<CauseKind> kinds;
  Coefficients residuals;
  std::vector<Coefficients> slopes;
};

}  // namespace

TEST_F(LinearResidualsTest, theFitFindsTheStrengths) {
  const Eigen::VectorXd x = linear({1.5, 0, -2}).fit({0, 2});
  EXPECT_NEAR(x[0], 1.5, 0.15);
  EXPECT_NEAR(x[1], -2, 0.15);
}

TEST_F(LinearResidualsTest, aStrengthStaysWithinItsBoundsAndTheOtherIsFittedWithIt) {
  kinds[2].lower = -1;
  const Eigen::VectorXd x = linear({1.5, 0, -2}).fit({0, 2});
  EXPECT_EQ(x[1], -1);
  EXPECT_NEAR(x[0], 1.5, 0.3);
}

TEST_F(LinearResidualsTest, noStrengthGoesFartherThanItsSlopeIsTrusted) {
  EXPECT_EQ(linear({7, 0, 0}).fit({0})[0], 4);
}

TEST_F(LinearResidualsTest, theTrueSetScoresBestAndCostsItsPrice) {
  const LinearResiduals of = linear({1.5, 0, -2});
  const double truth = of.score({0, 2}).score();
  EXPECT_GT(truth, of.score({0}).score());
  EXPECT_GT(truth, of.score({1, 2}).score());
  EXPECT_GT(truth, of.score({0, 1, 2}).score());
  EXPECT_NEAR(of.score({0, 2}).price, 2 * std::log(3.0), 1e-12);
}

TEST_F(LinearResidualsTest, aGroupLeftOutHasNoSayInItsStrengths) {
  // The third group alone wants another strength.
  residuals[2] -= 0.8 * slopes[0][2];
  const SetScore scored = linear({1, 0, 0}).score({0});
  EXPECT_NEAR(scored.without[2][0], 1, 0.2);
  EXPECT_GT(scored.without[0][0], 1.2);
  EXPECT_LT(scored.density[2], scored.density[0] - 10);
}

TEST_F(LinearResidualsTest, proposesWhatGainsMostWithASet) {
  const LinearResiduals of = linear({1.5, 0, -2});
  const StrengthSet none, one{{2}, Eigen::VectorXd::Constant(1, -2)};
  EXPECT_EQ(of.proposals(none, 1), std::vector<std::size_t>{2});
  EXPECT_EQ(of.proposals(one, 1), std::vector<std::size_t>{0});
}

TEST_F(LinearResidualsTest, theSameSetIsReadOffAboutAnyMiddle) {
  const StrengthSet middle{{0}, Eigen::VectorXd::Constant(1, 1.0)};
  Coefficients at = residuals;
  for (std::size_t c = 0; c < cells.size(); ++c) at[c] -= 0.5 * slopes[0][c];  // the truth is 1.5
  const LinearResiduals about(cells, 3, kinds, middle, at, slopes);
  EXPECT_NEAR(about.fit({0})[0], linear({1.5, 0, 0}).fit({0})[0], 0.02);
}

TEST(StrengthSet, tellsStrengthsByKind) {
  const StrengthSet set{{2, 5}, Eigen::Vector2d(0.5, -1)};
  EXPECT_TRUE(set.holds(5));
  EXPECT_FALSE(set.holds(3));
  EXPECT_EQ(set.at(5), -1);
  EXPECT_EQ(set.at(3), 0);
}

}  // namespace plumbline::gap
