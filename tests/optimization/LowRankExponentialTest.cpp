#include "optimization/LowRankExponential.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <tuple>

#include "math/Gaussians.h"

namespace plumbline {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random(int rows, int columns, std::uint64_t seed) {
  Random generator(seed);
  MatrixXd numbers(rows, columns);
  fillGaussian(generator, std::span(numbers.data(), static_cast<std::size_t>(numbers.size())));
  return numbers;
}

/// Against the exponential by eigenvectors, for as many columns as rows and for fewer.
TEST(LowRankExponential, isTheExponential) {
  for (const auto& [rows, columns, size] : {std::tuple{5, 12, 0.1}, {8, 8, 0.1}, {40, 30, 0.02}}) {
    const MatrixXd z = random(rows, columns, 1), shape = random(rows, rows, 2);
    const VectorXd weights = size * random(columns, 1, 3);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(z * weights.asDiagonal() * z.transpose());
    const VectorXd values = solver.eigenvalues().array().exp();
    EXPECT_GT(values.maxCoeff(), 1.3);
    const MatrixXd exact =
        shape * solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
    MatrixXd grown = shape;
    growByExponential(grown, shape * z, z, weights);
    EXPECT_LT((grown - exact).norm(), 1e-8 * exact.norm()) << rows << " x " << columns;
  }
}

TEST(LowRankExponential, ofNothingIsOne) {
  const MatrixXd z = random(6, 3, 1), shape = random(6, 6, 2);
  MatrixXd grown = shape;
  growByExponential(grown, shape * z, z, VectorXd::Zero(3));
  EXPECT_EQ(grown, shape);
}

}  // namespace
}  // namespace plumbline
