#include "optimization/LowRankExponential.h"

namespace plumbline {
namespace {

constexpr double leftOut = 1e-10;  // share of the whole
constexpr int mostTerms = 100;

/// first + first step / (1 + begin) + first step^2 / ((1 + begin) (2 + begin)) + ...
Eigen::MatrixXd series(const Eigen::MatrixXd& first, const Eigen::MatrixXd& step, int begin) {
  Eigen::MatrixXd sum = first, term = first, next(first.rows(), first.cols());
  for (int k = 1; k < mostTerms; ++k) {
    next.noalias() = term * step;
    term = next / (begin + k);
    sum += term;
    if (term.squaredNorm() <= leftOut * leftOut * sum.squaredNorm()) break;
  }
  return sum;
}

}  // namespace

void growByExponential(Eigen::MatrixXd& shape, const Eigen::MatrixXd& shapeTimesZ, const Eigen::MatrixXd& z,
                       const Eigen::VectorXd& weights) {
  if (z.rows() <= z.cols()) {
    Eigen::MatrixXd exponent(z.rows(), z.rows());
    exponent.noalias() = (z * weights.asDiagonal()) * z.transpose();
    shape = series(shape, exponent, 0);
    return;
  }
  // exp(z A z') = 1 + z (A + A B / 2 + A B^2 / 6 + ...) z' with B = z' z A.
  Eigen::MatrixXd gram(z.cols(), z.cols());
  gram.noalias() = z.transpose() * z;
  const Eigen::MatrixXd step = gram * weights.asDiagonal();
  const Eigen::MatrixXd second = 0.5 * (weights.asDiagonal() * step);
  Eigen::MatrixXd inside = series(second, step, 2);
  inside.diagonal() += weights;
  const Eigen::MatrixXd grown = shapeTimesZ * inside;
  shape.noalias() += grown * z.transpose();
}

}  // namespace plumbline
