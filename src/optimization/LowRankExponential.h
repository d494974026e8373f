#pragma once
#include <Eigen/Core>

namespace plumbline {

/// shape times the matrix exponential of z diag(weights) z', as a series. shape: n x n; z: n x k;
/// shapeTimesZ: their product, which a search has from drawing its candidates. With k < n the series is taken
/// in the k columns alone, as every power of the exponent keeps z at either end; no eigenvectors are needed.
/// Terms below 1e-10 of the whole are left out: meant for exponents whose norm is not much above 1.
void growByExponential(Eigen::MatrixXd& shape, const Eigen::MatrixXd& shapeTimesZ, const Eigen::MatrixXd& z,
                       const Eigen::VectorXd& weights);

}  // namespace plumbline
