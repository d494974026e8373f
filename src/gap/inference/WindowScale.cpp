#include "gap/inference/WindowScale.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "gap/inference/Likelihood.h"

namespace plumbline::gap {

namespace {

constexpr int scaleRounds = 3;

}  // namespace

Eigen::MatrixXd raisedTo(const Eigen::MatrixXd& floor, const Eigen::MatrixXd& moment) {
  const Eigen::LLT<Eigen::MatrixXd> factor(floor);
  const auto lower = factor.matrixL();
  const Eigen::MatrixXd half = lower.solve(moment);
  const Eigen::MatrixXd white = lower.solve(half.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((white + white.transpose()) / 2);
  const Eigen::MatrixXd axes = lower * solver.eigenvectors();
  return axes * solver.eigenvalues().cwiseMax(1.0).asDiagonal() * axes.transpose();
}

WindowScale likeliestScale(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& floor) {
  const auto n = static_cast<double>(columns.rows()), count = static_cast<double>(columns.cols());
  WindowScale scale{floor, Eigen::VectorXd::Ones(columns.cols()), 0};
  for (int round = 0; round < scaleRounds; ++round) {
    scale.covariance = raisedTo(floor, columns * scale.weights.asDiagonal() * columns.transpose() / count);
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
