#pragma once
#include <Eigen/Core>

namespace plumbline::gap {

/// What the residuals of a cell are drawn from: a multivariate Student-t density with four degrees of
/// freedom.
struct CellScale {
  Eigen::MatrixXd covariance;  ///< the likeliest that is nowhere below 1, that of a perfect model
  Eigen::VectorXd weights;     ///< per column: what it counts for, (4 + n) / (4 + r' inv(covariance) r)
  double density = 0;          ///< sum of the columns' log densities, up to a constant
};

/// columns: white coefficients of a stretch each. What the likeliest covariance is above 1 is the model's
/// discrepancy (Kennedy and O'Hagan 2001). By iteratively reweighted moments.
CellScale likeliestScale(const Eigen::MatrixXd& columns);

/// The covariance of normal vectors with this second moment that is likeliest and nowhere below 1: its
/// eigenvalues are raised to 1.
Eigen::MatrixXd raisedToOne(const Eigen::MatrixXd& moment);

}  // namespace plumbline::gap
