#include "gap/inference/CellScale.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "gap/inference/Likelihood.h"

namespace plumbline::gap {

namespace {

constexpr int scaleRounds = 3;

}  // namespace

Eigen::MatrixXd raisedToOne(const Eigen::MatrixXd& moment) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(moment);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(1.0).asDiagonal() *
         solver.eigenvectors().transpose();
}

CellScale likeliestScale(const Eigen::MatrixXd& columns) {
  const auto n = static_cast<double>(columns.rows()), count = static_cast<double>(columns.cols());
  CellScale scale{{}, Eigen::VectorXd::Ones(columns.cols()), 0};
  for (int round = 0; round < scaleRounds; ++round) {
    scale.covariance = raisedToOne(columns * scale.weights.asDiagonal() * columns.transpose() / count);
    const Eigen::LLT<Eigen::MatrixXd> factor(scale.covariance);
    const Eigen::MatrixXd white = factor.matrixL().solve(columns);
    const Eigen::ArrayXd squares = white.colwise().squaredNorm().transpose().array();
    scale.weights = (tailFreedom + n) / (tailFreedom + squares);
    scale.density = -count * factor.matrixLLT().diagonal().array().log().sum() -
                    (tailFreedom + n) / 2 * (squares / tailFreedom).log1p().sum();
  }
  return scale;
}

}  // namespace plumbline::gap
