#include "gap/replay/SmallFactor.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace plumbline::gap {
namespace {

/// Symmetric, positive definite, with a known condition: B B' + 0.1 of rows that no two are alike.
Eigen::MatrixXd matrixOf(Eigen::Index n) {
  Eigen::MatrixXd B(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) B(i, j) = std::sin(1.0 + 3.0 * static_cast<double>(i * n + j));
  return B * B.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
}

TEST(SmallFactor, solvesAsEigenDoes) {
  for (const Eigen::Index n : {1, 2, 6, 30}) {
    const Eigen::MatrixXd A = matrixOf(n);
    SmallFactor::Rows B(n, 4);
    for (Eigen::Index c = 0; c < 4; ++c) B.col(c) = Eigen::VectorXd::LinSpaced(n, -1, static_cast<double>(c));
    SmallFactor factor;
    factor.compute(A);
    SmallFactor::Rows X = B;
    factor.solveInPlace(X);
    EXPECT_LT((X - A.llt().solve(Eigen::MatrixXd(B))).norm(), 1e-11 * X.norm()) << n;
    EXPECT_EQ(factor.rows(), n);
  }
}

TEST(SmallFactor, solvesTheSameWhileItIsComputed) {
  for (const Eigen::Index n : {1, 5, 6, 13})
    for (const Eigen::Index width : {1, 2, 3, 7, 8, 12}) {
      SmallFactor::Rows B(n, width);
      for (Eigen::Index c = 0; c < width; ++c)
        B.col(c) = Eigen::VectorXd::LinSpaced(n, -1, static_cast<double>(c));
      SmallFactor::Rows X = B, Y = B;
      SmallFactor one, two;
      one.compute(matrixOf(n));
      one.solveInPlace(X);
      two.computeAndSolve(matrixOf(n), Y);
      EXPECT_EQ(X, Y) << n << " " << width;
      two.solveInPlace(B);
      EXPECT_EQ(X, B);
    }
}

TEST(SmallFactor, aFullWidthIsOneOfEightOrHardlyMore) {
  EXPECT_EQ(SmallFactor::fullWidth(1), 1);
  EXPECT_EQ(SmallFactor::fullWidth(2), 2);
  EXPECT_EQ(SmallFactor::fullWidth(3), 8);
  EXPECT_EQ(SmallFactor::fullWidth(7), 8);
  EXPECT_EQ(SmallFactor::fullWidth(8), 8);
  EXPECT_EQ(SmallFactor::fullWidth(10), 10);
  EXPECT_EQ(SmallFactor::fullWidth(11), 16);
}

TEST(SmallFactor, looksAtTheLowerTriangleAlone) {
  const Eigen::MatrixXd A = matrixOf(5);
  SmallFactor whole, lower;
  whole.compute(A);
  lower.compute(A.triangularView<Eigen::Lower>());
  SmallFactor::Rows x = Eigen::VectorXd::Ones(5), y = x;
  whole.solveInPlace(x);
  lower.solveInPlace(y);
  EXPECT_EQ(x, y);
}

TEST(SmallFactor, aColumnIsSolvedTheSameWithOthers) {
  SmallFactor factor;
  factor.compute(matrixOf(6));
  SmallFactor::Rows columns = 0.5 * Eigen::MatrixXd::Identity(6, 6);
  factor.solveInPlace(columns);
  for (Eigen::Index row = 0; row < 6; ++row) {
    SmallFactor::Rows x = Eigen::VectorXd::Zero(6);
    x(row, 0) = 0.5;
    factor.solveInPlace(x);
    EXPECT_EQ(x.col(0), columns.col(row));
  }
}

TEST(SmallFactor, ofAMatrixThatIsNotPositiveNothingIsFinite) {
  SmallFactor factor;
  factor.compute(-Eigen::MatrixXd::Identity(3, 3));
  SmallFactor::Rows x = Eigen::VectorXd::Ones(3);
  factor.solveInPlace(x);
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_FALSE(std::isfinite(x(i, 0)));
}

}  // namespace
}  // namespace plumbline::gap
