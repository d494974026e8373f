#include "gap/replay/SmallFactor.h"

#include <algorithm>
#include <cmath>

#include "gap/replay/DoublePair.h"

namespace plumbline::gap {

namespace {

/// L L' x = b for as many columns as T has numbers. X: n rows, `width` apart.
template <typename T>
void solveColumns(const Eigen::MatrixXd& L, const double* reciprocal, double* X, Eigen::Index width) {
  const Eigen::Index n = L.cols(), stride = L.rows();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double* factor = L.data() + i;
    auto row = readDoubles<T>(X + i * width);
    for (const double* other = X; other != X + i * width; other += width, factor += stride)
      row = less(row, *factor, readDoubles<T>(other));
    writeDoubles(X + i * width, times(row, reciprocal[i]));
  }
  for (Eigen::Index j = n; j-- > 0;) {
    const double* const column = L.data() + j * stride;
    auto row = readDoubles<T>(X + j * width);
    for (Eigen::Index i = j + 1; i < n; ++i)
      row = less(row, column[i], readDoubles<T>(X + i * width));
    writeDoubles(X + j * width, times(row, reciprocal[j]));
  }
}

}  // namespace

void SmallFactor::compute(const Eigen::MatrixXd& A) {
  const Eigen::Index n = A.rows(), stride = n + n % 2;
  if (L_.cols() != n) {
    L_.setZero(stride, n);
    reciprocal_.resize(n);
  }
  // Pairs of rows: beside the lower triangle they hold numbers that nobody reads.
  if (stride == n) {
    std::copy_n(A.data(), n * n, L_.data());
  } else {
    for (Eigen::Index k = 0; k < n; ++k) std::copy_n(A.data() + k * n, n, L_.data() + k * stride);
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    double* const column = L_.data() + j * stride;
    const double root = std::sqrt(column[j]), over = 1 / root;
    column[j] = root;
    reciprocal_[j] = over;
    for (Eigen::Index i = j + 1; i < n; ++i) column[i] *= over;
    for (Eigen::Index k = j + 1; k < n; ++k) {
      double* const other = L_.data() + k * stride;
      const double factor = column[k];
      for (Eigen::Index i = k - k % 2; i < stride; i += 2)
        writeDoubles(other + i, less(readDoubles<DoublePair>(other + i), factor, readDoubles<DoublePair>(column + i)));
    }
  }
}

void SmallFactor::solveInPlace(Rows& X) const {
  const Eigen::Index width = X.cols();
  double* const data = X.data();
  Eigen::Index c = 0;
  for (; c + 8 <= width; c += 8) solveColumns<DoubleEight>(L_, reciprocal_.data(), data + c, width);
  for (; c + 2 <= width; c += 2) solveColumns<DoublePair>(L_, reciprocal_.data(), data + c, width);
  if (c < width) solveColumns<double>(L_, reciprocal_.data(), data + c, width);
}

Eigen::Index SmallFactor::fullWidth(Eigen::Index columns) {
  return columns % 8 > 2 ? columns + 8 - columns % 8 : columns;
}

}  // namespace plumbline::gap
