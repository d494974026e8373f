#include "gap/replay/SmallFactor.h"

#include <cmath>

namespace plumbline::gap {

void SmallFactor::compute(const Eigen::MatrixXd& A) {
  const Eigen::Index n = A.rows();
  L_ = A;
  reciprocal_.resize(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    double* const column = L_.col(j).data();
    const double root = std::sqrt(column[j]), over = 1 / root;
    column[j] = root;
    reciprocal_[j] = over;
    for (Eigen::Index i = j + 1; i < n; ++i) column[i] *= over;
    for (Eigen::Index k = j + 1; k < n; ++k) {
      double* const other = L_.col(k).data();
      const double factor = column[k];
      for (Eigen::Index i = k; i < n; ++i) other[i] -= factor * column[i];
    }
  }
}

void SmallFactor::solveInPlace(Rows& X) const {
  const Eigen::Index n = L_.rows(), width = X.cols();
  const auto subtract = [width](double* from, double factor, const double* row) {
    for (Eigen::Index c = 0; c < width; ++c) from[c] -= factor * row[c];
  };
  const auto scale = [width](double* row, double factor) {
    for (Eigen::Index c = 0; c < width; ++c) row[c] *= factor;
  };
  for (Eigen::Index j = 0; j < n; ++j) {
    double* const row = X.row(j).data();
    scale(row, reciprocal_[j]);
    for (Eigen::Index i = j + 1; i < n; ++i) subtract(X.row(i).data(), L_(i, j), row);
  }
  for (Eigen::Index j = n; j-- > 0;) {
    double* const row = X.row(j).data();
    for (Eigen::Index i = j + 1; i < n; ++i) subtract(row, L_(i, j), X.row(i).data());
    scale(row, reciprocal_[j]);
  }
}

}  // namespace plumbline::gap
