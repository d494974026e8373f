#pragma once
#include <Eigen/Core>

namespace plumbline::gap {

/// Cholesky factor A = L L' of a symmetric positive definite matrix of up to some thirty rows. Eigen's packs
/// blocks and asks for memory, which costs more than the arithmetic of six rows. Does not check: of another
/// matrix the solutions are not finite.
class SmallFactor {
public:
  /// Looks at the lower triangle of A.
  void compute(const Eigen::MatrixXd& A);
  Eigen::Index rows() const { return L_.cols(); }

  /// X: A X = B, in the place of B. Row by row, so that the columns are worked out side by side: eight
  /// at once, then two, then one.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  void solveInPlace(Rows& X) const;
  /// Both, in less time; X must have columns.
  void computeAndSolve(const Eigen::MatrixXd& A, Rows& X);
  /// Least number of columns, not below this one, that are solved as fast as any fewer.
  static Eigen::Index fullWidth(Eigen::Index columns);

private:
  void take(const Eigen::MatrixXd& A);
  template <typename T>
  void eliminate(double* X, Eigen::Index width);
  template <typename T>
  void solveForward(double* X, Eigen::Index width) const;
  template <typename T>
  void solveBackward(double* X, Eigen::Index width) const;
  void solveFrom(Rows& X, Eigen::Index c) const;

  Eigen::MatrixXd L_;           ///< below its diagonal; an even number of rows
  Eigen::VectorXd reciprocal_;  ///< of its diagonal
};

}  // namespace plumbline::gap
