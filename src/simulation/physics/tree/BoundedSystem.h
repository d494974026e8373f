#pragma once
#include <Eigen/Core>
#include <vector>

namespace plumbline::simulation {

/// A linear complementarity problem with bounds: find x so that lower <= x <= upper for each i. With
/// w = A x - b, w >= 0 if x is at its lower bound, w <= 0 at its upper, w = 0 between. A is
/// symmetric and positive definite, so there is one solution.
///
/// Rows without bounds are eliminated first; among the others the set of those at a bound is found by block
/// principal pivoting, which is finite (J. J. Judice, F. M. Pires, A block principal pivoting algorithm for
/// large-scale strictly monotone linear complementarity problems, Computers & Operations Research 21, 1994).
class BoundedSystem {
public:
  /// Size and zeroes for all; bounds infinite.
  void reset(Eigen::Index size);
  Eigen::MatrixXd a;  ///< its lower triangle counts
  Eigen::VectorXd b, lower, upper;

  /// The solution, valid until the next call.
  const Eigen::VectorXd& solve();
  const Eigen::VectorXd& solution() const { return x_; }

private:
  void pivot();
  void solveFree();
  std::vector<Eigen::Index> free_, bounded_, inner_;
  std::vector<int> bound_;  ///< of the bounded rows: -1 lower, 0 between, 1 upper
  Eigen::MatrixXd freeMatrix_, cross_, rest_, innerMatrix_;
  Eigen::VectorXd freeSide_, restSide_, restX_, innerSide_, x_;
  Eigen::VectorXd restLower_, restUpper_;
};

}  // namespace plumbline::simulation
