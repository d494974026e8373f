#include "gap/inference/CellScale.h"

#include <gtest/gtest.h>

namespace plumbline::gap {

TEST(CellScale, aMomentBelowOneIsRaisedToIt) {
  const Eigen::Matrix2d moment = Eigen::Vector2d(0.2, 9).asDiagonal();
  EXPECT_TRUE(raisedToOne(moment).isApprox(Eigen::Matrix2d(Eigen::Vector2d(1, 9).asDiagonal()), 1e-12));
}

TEST(CellScale, whatIsAboveOneInEveryDirectionStays) {
  Eigen::Matrix2d moment;
  moment << 5, 2, 2, 6;
  EXPECT_TRUE(raisedToOne(moment).isApprox(moment, 1e-12));
}

TEST(CellScale, residualsOfAPerfectModelsSizeKeepItsCovariance) {
  Eigen::MatrixXd columns(2, 8);
  columns << 1, -1, 1, -1, 1, -1, 1, -1, 1, 1, -1, -1, 1, 1, -1, -1;
  EXPECT_TRUE(likeliestScale(0.1 * columns).covariance.isApprox(Eigen::Matrix2d::Identity(), 1e-12));
}

TEST(CellScale, aWindowFarOffCountsForLittle) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Ones(1, 10);
  columns(0, 9) = 100;
  const CellScale scale = likeliestScale(columns);
  EXPECT_LT(scale.weights[9], 0.1 * scale.weights[0]);
  EXPECT_LT(scale.covariance(0, 0), 1000);  // its plain second moment is 1001
}

TEST(CellScale, smallerResidualsAreLikelierDownToTheFloorAlone) {
  const Eigen::MatrixXd columns = 10 * Eigen::MatrixXd::Ones(3, 20);
  const double large = likeliestScale(columns).density, half = likeliestScale(columns / 2).density,
               tiny = likeliestScale(columns / 1e4).density, none = likeliestScale(columns * 0).density;
  EXPECT_GT(half, large + 5);
  EXPECT_NEAR(tiny, none, 1e-3);
}

}  // namespace plumbline::gap
