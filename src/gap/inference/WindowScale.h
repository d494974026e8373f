#pragma once
#include <Eigen/Core>

namespace plumbline::gap {

/// What the residuals of a cell are drawn from: a multivariate Student-t density with four degrees of
/// freedom.
struct WindowScale {
  Eigen::MatrixXd covariance;  ///< the likeliest that is nowhere below the floor
  Eigen::VectorXd weights;     ///< per window: what it counts for, (4 + n) / (4 + r' inv(covariance) r)
  double density = 0;          ///< sum of the windows' log densities, up to a constant
};

/// columns: a window's coefficients each. floor: their covariance under a perfect model; what the likeliest
/// one is above it is the model's discrepancy (Kennedy and O'Hagan 2001). By iteratively reweighted moments.
WindowScale likeliestScale(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& floor);

/// The covariance of normal vectors with this second moment that is likeliest and nowhere below a floor: with
/// floor = L L', the eigenvalues of inv(L) moment inv(L') are raised to 1.
Eigen::MatrixXd raisedTo(const Eigen::MatrixXd& floor, const Eigen::MatrixXd& moment);

}  // namespace plumbline::gap
