#include "simulation/physics/tree/BoundedSystem.h"

#include <Eigen/Cholesky>
#include <limits>

#include "math/Resize.h"

namespace plumbline::simulation {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Rounding error of an impulse or a velocity; a row this close to a change of sides stays where it is.
constexpr double rounding = 1e-12;
using InPlaceCholesky = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;

}  // namespace

void BoundedSystem::reset(Eigen::Index size) {
  resizeInUse(a, size, size);
  for (Eigen::VectorXd* vector : {&b, &lower, &upper}) resizeInUse(*vector, size);
  a.setZero();
  b.setZero();
  lower.setConstant(-infinity);
  upper.setConstant(infinity);
}

const Eigen::VectorXd& BoundedSystem::solve() {
  free_.clear();
  bounded_.clear();
  for (Eigen::Index i = 0; i < b.size(); ++i)
    (lower[i] == -infinity && upper[i] == infinity ? free_ : bounded_).push_back(i);
  const auto entry = [&](Eigen::Index i, Eigen::Index j) { return i >= j ? a(i, j) : a(j, i); };
  const auto nf = static_cast<Eigen::Index>(free_.size()), nb = static_cast<Eigen::Index>(bounded_.size());

  resizeInUse(freeMatrix_, nf, nf);
  resizeInUse(freeSide_, nf);
  resizeInUse(cross_, nf, nb);
  resizeInUse(rest_, nb, nb);
  resizeInUse(restSide_, nb);
  resizeInUse(restLower_, nb);
  resizeInUse(restUpper_, nb);
  for (Eigen::Index j = 0; j < nf; ++j) {
    const Eigen::Index fj = free_[static_cast<std::size_t>(j)];
    freeSide_[j] = b[fj];
    for (Eigen::Index i = j; i < nf; ++i) freeMatrix_(i, j) = entry(free_[static_cast<std::size_t>(i)], fj);
  }
  for (Eigen::Index j = 0; j < nb; ++j) {
    const Eigen::Index bj = bounded_[static_cast<std::size_t>(j)];
    restSide_[j] = b[bj];
    restLower_[j] = lower[bj];
    restUpper_[j] = upper[bj];
    for (Eigen::Index i = 0; i < nf; ++i) cross_(i, j) = entry(free_[static_cast<std::size_t>(i)], bj);
    for (Eigen::Index i = j; i < nb; ++i) rest_(i, j) = entry(bounded_[static_cast<std::size_t>(i)], bj);
  }

  // Block elimination of the free rows: L L^T = A_ff, cross = L^-1 A_fb, side = L^-1 b_f.
  const InPlaceCholesky cholesky(freeMatrix_);
  // Matrices without a row or column are not passed to Eigen: it would form references from null pointers.
  if (nf > 0) cholesky.matrixL().solveInPlace(freeSide_);
  if (nf > 0 && nb > 0) {
    cholesky.matrixL().solveInPlace(cross_);
    rest_.selfadjointView<Eigen::Lower>().rankUpdate(cross_.transpose(), -1);
    restSide_.noalias() -= cross_.transpose() * freeSide_;
  }

  pivot();

  if (nf > 0 && nb > 0) freeSide_.noalias() -= cross_ * restX_;
  if (nf > 0) cholesky.matrixU().solveInPlace(freeSide_);
  resizeInUse(x_, b.size());
  for (Eigen::Index i = 0; i < nf; ++i) x_[free_[static_cast<std::size_t>(i)]] = freeSide_[i];
  for (Eigen::Index i = 0; i < nb; ++i) x_[bounded_[static_cast<std::size_t>(i)]] = restX_[i];
  return x_;
}

void BoundedSystem::pivot() {
  const auto n = static_cast<std::size_t>(restSide_.size());
  bound_.assign(n, 0);
  resizeInUse(restX_, restSide_.size());
  restX_.setZero();
  std::vector<int> wanted(n);
  int allowance = 3;
  std::size_t fewest = n + 1;
  // Far more rounds than pivoting needs; then only rounding keeps a row undecided; both sides are right.
  for (int round = 0; round < 1000; ++round) {
    solveFree();
    std::size_t wrong = 0, last = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      wanted[i] = bound_[i];
      if (bound_[i] == 0) {
        if (restX_[k] < restLower_[k] - rounding) wanted[i] = -1;
        if (restX_[k] > restUpper_[k] + rounding) wanted[i] = 1;
      } else {
        double w = -restSide_[k];
        for (Eigen::Index j = 0; j < restX_.size(); ++j)
          w += (k >= j ? rest_(k, j) : rest_(j, k)) * restX_[j];
        if (w * bound_[i] > rounding) wanted[i] = 0;
      }
      if (wanted[i] != bound_[i]) {
        ++wrong;
        last = i;
      }
    }
    if (wrong == 0) return;
    if (wrong < fewest) {
      fewest = wrong;
      allowance = 3;
    } else if (allowance > 0) {
      --allowance;
    } else {  // one at a time, which cannot cycle
      bound_[last] = wanted[last];
      continue;
    }
    bound_ = wanted;
  }
}

void BoundedSystem::solveFree() {
  inner_.clear();
  for (std::size_t i = 0; i < bound_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (bound_[i] == 0)
      inner_.push_back(k);
    else
      restX_[k] = bound_[i] < 0 ? restLower_[k] : restUpper_[k];
  }
  const auto n = static_cast<Eigen::Index>(inner_.size());
  resizeInUse(innerMatrix_, n, n);
  resizeInUse(innerSide_, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Index kj = inner_[static_cast<std::size_t>(j)];
    innerSide_[j] = restSide_[kj];
    for (std::size_t i = 0; i < bound_.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (bound_[i] != 0) innerSide_[j] -= (kj >= k ? rest_(kj, k) : rest_(k, kj)) * restX_[k];
    }
    for (Eigen::Index i = j; i < n; ++i) innerMatrix_(i, j) = rest_(inner_[static_cast<std::size_t>(i)], kj);
  }
  if (n == 0) return;
  const InPlaceCholesky cholesky(innerMatrix_);
  cholesky.matrixL().solveInPlace(innerSide_);
  cholesky.matrixU().solveInPlace(innerSide_);
  for (Eigen::Index j = 0; j < n; ++j) restX_[inner_[static_cast<std::size_t>(j)]] = innerSide_[j];
}

}  // namespace plumbline::simulation
