#include "math/SolvePositive.h"

#include <gtest/gtest.h>

namespace plumbline {

TEST(SolvePositive, findsWhatAMatrixTurnsIntoTheRightSide) {
  Eigen::Matrix<double, 5, 5> J;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) J(i, j) = std::sin(1.0 + 3 * i + 7 * j * j);
  const Eigen::Matrix<double, 5, 5> A = J * J.transpose() + Eigen::Matrix<double, 5, 5>::Identity();
  const Eigen::Matrix<double, 5, 1> x(1, -2, 3, -4, 5);
  Eigen::Matrix<double, 5, 1> b = A * x;
  ASSERT_TRUE(solvePositive(A, b));
  EXPECT_LT((b - x).norm(), 1e-13);
}

TEST(SolvePositive, readsTheLowerHalfAlone) {
  Eigen::Matrix2d A;
  A << 4, std::nan(""), 2, 3;
  Eigen::Vector2d b(8, 7);
  ASSERT_TRUE(solvePositive(A, b));
  EXPECT_NEAR(b.x(), 1.25, 1e-15);
  EXPECT_NEAR(b.y(), 1.5, 1e-15);
}

TEST(SolvePositive, refusesWhatIsNotPositive) {
  Eigen::Matrix2d A;
  A << 1, 2, 2, 1;
  Eigen::Vector2d b(1, 1);
  EXPECT_FALSE(solvePositive(A, b));
  A << 1, 1, 1, 1;
  EXPECT_FALSE(solvePositive(A, b));
  A << std::nan(""), 0, 0, 1;
  EXPECT_FALSE(solvePositive(A, b));
}

}  // namespace plumbline
