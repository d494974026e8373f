#pragma once
#include <Eigen/Core>
#include <cmath>

namespace plumbline {

/// Turns `b` into the x of A x = b, for a symmetric positive definite A (N x N; only its lower half is read).
/// False where A is not positive definite as far as rounding shows; b is then meaningless. Cholesky's
/// factors in plain loops: a decomposition of Eigen takes one to six seconds to compile for each size.
template <int N>
bool solvePositive(Eigen::Matrix<double, N, N> A, Eigen::Matrix<double, N, 1>& b) {
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j <= i; ++j) {
      double rest = A(i, j);
      for (int k = 0; k < j; ++k) rest -= A(i, k) * A(j, k);
      if (j < i)
        A(i, j) = rest / A(j, j);
      else if (rest > 0)
        A(i, i) = std::sqrt(rest);
      else
        return false;
    }
    for (int k = 0; k < i; ++k) b(i) -= A(i, k) * b(k);
    b(i) /= A(i, i);
  }
  for (int i = N - 1; i >= 0; --i) {
    for (int k = i + 1; k < N; ++k) b(i) -= A(k, i) * b(k);
    b(i) /= A(i, i);
  }
  return true;
}

}  // namespace plumbline
