#include "gap/replay/SmallFactor.h"

#include <algorithm>
#include <cmath>

#include "gap/replay/DoublePair.h"

namespace plumbline::gap {

// Each of these works on as many columns as T has numbers. X: n rows, `width` apart.

/// Makes the factor from A in its place. Takes the columns through L x = b on the way: that fills the time in
/// which the next root is awaited. X null: no columns.
template <typename T>
void SmallFactor::eliminate(double* X, Eigen::Index width) {
  const Eigen::Index n = L_.cols(), stride = L_.rows();
  for (Eigen::Index j = 0; j < n; ++j) {
    double* const column = L_.data() + j * stride;
    const double over = 1 / std::sqrt(column[j]);
    reciprocal_.data()[j] = over;
    // Pairs of rows: on the diagonal and above it they leave numbers that nobody reads.
    for (Eigen::Index i = j + 1 - (j + 1) % 2; i < stride; i += 2)
      writeDoubles(column + i, scaled(readDoubles<DoublePair>(column + i), over));
    for (Eigen::Index k = j + 1; k < n; ++k) {
      double* const other = L_.data() + k * stride;
      const double factor = column[k];
      for (Eigen::Index i = k - k % 2; i < stride; i += 2)
        writeDoubles(other + i, minusScaled(readDoubles<DoublePair>(other + i), factor,
                                            readDoubles<DoublePair>(column + i)));
    }
    if (!X) continue;
    const T row = scaled(readDoubles<T>(X + j * width), over);
    writeDoubles(X + j * width, row);
    for (Eigen::Index k = j + 1; k < n; ++k)
      writeDoubles(X + k * width, minusScaled(readDoubles<T>(X + k * width), column[k], row));
  }
}

/// L x = b.
template <typename T>
void SmallFactor::solveForward(double* X, Eigen::Index width) const {
  const Eigen::Index n = L_.cols(), stride = L_.rows();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double* factor = L_.data() + i;
    auto row = readDoubles<T>(X + i * width);
    for (const double* other = X; other != X + i * width; other += width, factor += stride)
      row = minusScaled(row, *factor, readDoubles<T>(other));
    writeDoubles(X + i * width, scaled(row, reciprocal_.data()[i]));
  }
}

/// L' x = b.
template <typename T>
void SmallFactor::solveBackward(double* X, Eigen::Index width) const {
  const Eigen::Index n = L_.cols(), stride = L_.rows();
  for (Eigen::Index j = n; j-- > 0;) {
    const double* const column = L_.data() + j * stride;
    auto row = readDoubles<T>(X + j * width);
    for (Eigen::Index i = j + 1; i < n; ++i) row = minusScaled(row, column[i], readDoubles<T>(X + i * width));
    writeDoubles(X + j * width, scaled(row, reciprocal_.data()[j]));
  }
}

void SmallFactor::take(const Eigen::MatrixXd& A) {
  const Eigen::Index n = A.rows(), stride = n + n % 2;
  if (L_.cols() != n) {
    L_.setZero(stride, n);
    reciprocal_.resize(n);
  }
  if (stride == n) {
    std::copy_n(A.data(), n * n, L_.data());
  } else {
    for (Eigen::Index k = 0; k < n; ++k) std::copy_n(A.data() + k * n, n, L_.data() + k * stride);
  }
}

void SmallFactor::compute(const Eigen::MatrixXd& A) {
  take(A);
  eliminate<double>(nullptr, 0);
}

void SmallFactor::solveFrom(Rows& X, Eigen::Index c) const {
  const Eigen::Index width = X.cols();
  const auto solve = [&]<typename T>(T) {
    solveForward<T>(X.data() + c, width);
    solveBackward<T>(X.data() + c, width);
    c += static_cast<Eigen::Index>(sizeof(T) / sizeof(double));
  };
  while (c + 8 <= width) solve(DoubleEight{});
  while (c + 2 <= width) solve(DoublePair{});
  if (c < width) solve(0.0);
}

void SmallFactor::solveInPlace(Rows& X) const { solveFrom(X, 0); }

void SmallFactor::computeAndSolve(const Eigen::MatrixXd& A, Rows& X) {
  take(A);
  const Eigen::Index width = X.cols();
  const auto solve = [&]<typename T>(T) {
    eliminate<T>(X.data(), width);
    solveBackward<T>(X.data(), width);
    solveFrom(X, static_cast<Eigen::Index>(sizeof(T) / sizeof(double)));
  };
  if (width >= 8) {
    solve(DoubleEight{});
  } else if (width >= 2) {
    solve(DoublePair{});
  } else {
    solve(0.0);
  }
}

Eigen::Index SmallFactor::fullWidth(Eigen::Index columns) {
  return columns % 8 > 2 ? columns + 8 - columns % 8 : columns;
}

}  // namespace plumbline::gap
