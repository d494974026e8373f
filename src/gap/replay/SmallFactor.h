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
  /// Least number of columns, not below this one, that are solved as fast as any fewer.
  static Eigen::Index fullWidth(Eigen::Index columns);

private:
  Eigen::MatrixXd L_;           ///< lower triangle; an even number of rows
  Eigen::VectorXd reciprocal_;  ///< of its diagonal
};

}  // namespace plumbline::gap
