#include "simulation/physics/tree/BoundedSystem.h"

#include <Eigen/Cholesky>
#include <limits>

namespace plumbline::simulation {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// What rounding may do to an impulse or a velocity; a row within it of a change of sides stays where it is.
constexpr double rounding = 1e-12;
using InPlaceCholesky = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;

}  // namespace

void BoundedSystem::reset(Eigen::Index size) {
  a.setZero(size, size);
  b.setZero(size);
  lower.setConstant(size, -infinity);
  upper.setConstant(size, infinity);
}

const Eigen::VectorXd& BoundedSystem::solve() {
  free_.clear();
  bounded.clear();
  for (Eigen::Index i = 0; i < b.size(); ++i)
    (lower[i] == -infinity && upper[i] == infinity ? free_ : bounded).push_back(i);
  const auto entry = [&](Eigen::Index i, Eigen::Index j) { return i >= j ? a(i, j) : a(j, i); };
  const auto nf = static_cast<Eigen::Index>(free_.size()), nb = static_cast<Eigen::Index>(bounded.size());

  freeMatrix.resize(nf, nf);
  freeSide.resize(nf);
  cross_.resize(nf, nb);
  rest.resize(nb, nb);
  restSide.resize(nb);
  restLower.resize(nb);
  restUpper.resize(nb);
  for (Eigen::Index j = 0; j < nf; ++j) {
    const Eigen::Index fj = free_[static_cast<std::size_t>(j)];
    freeSide[j] = b[fj];
    for (Eigen::Index i = j; i < nf; ++i) freeMatrix(i, j) = entry(free_[static_cast<std::size_t>(i)], fj);
  }
  for (Eigen::Index j = 0; j < nb; ++j) {
    const Eigen::Index bj = bounded[static_cast<std::size_t>(j)];
    restSide[j] = b[bj];
    restLower[j] = lower[bj];
    restUpper[j] = upper[bj];
    for (Eigen::Index i = 0; i < nf; ++i) cross_(i, j) = entry(free_[static_cast<std::size_t>(i)], bj);
    for (Eigen::Index i = j; i < nb; ++i) rest(i, j) = entry(bounded[static_cast<std::size_t>(i)], bj);
  }

  // Block elimination of the free rows: L L^T = A_ff, cross = L^-1 A_fb, side = L^-1 b_f.
  const InPlaceCholesky cholesky(freeMatrix);
  // Eigen is not asked about matrices without a row or column: it would form references from null pointers.
  if (nf > 0) cholesky.matrixL().solveInPlace(freeSide);
  if (nf > 0 && nb > 0) {
    cholesky.matrixL().solveInPlace(cross_);
    rest.selfadjointView<Eigen::Lower>().rankUpdate(cross_.transpose(), -1);
    restSide.noalias() -= cross_.transpose() * freeSide;
  }

  pivot();

  if (nf > 0 && nb > 0) freeSide.noalias() -= cross_ * restX;
  if (nf > 0) cholesky.matrixU().solveInPlace(freeSide);
  x.resize(b.size());
  for (Eigen::Index i = 0; i < nf; ++i) x[free_[static_cast<std::size_t>(i)]] = freeSide[i];
  for (Eigen::Index i = 0; i < nb; ++i) x[bounded[static_cast<std::size_t>(i)]] = restX[i];
  return x;
}

void BoundedSystem::pivot() {
  const auto n = static_cast<std::size_t>(restSide.size());
  bound.assign(n, 0);
  restX.setZero(restSide.size());
  std::vector<int> wanted(n);
  int allowance = 3;
  std::size_t fewest = n + 1;
  // Far more rounds than pivoting needs; past them rounding keeps a row undecided, and either way is right.
  for (int round = 0; round < 1000; ++round) {
    solveFree();
    std::size_t wrong = 0, last = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      wanted[i] = bound[i];
      if (bound[i] == 0) {
        if (restX[k] < restLower[k] - rounding) wanted[i] = -1;
        if (restX[k] > restUpper[k] + rounding) wanted[i] = 1;
      } else {
        double w = -restSide[k];
        for (Eigen::Index j = 0; j < restX.size(); ++j) w += (k >= j ? rest(k, j) : rest(j, k)) * restX[j];
        if (w * bound[i] > rounding) wanted[i] = 0;
      }
      if (wanted[i] != bound[i]) {
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
      bound[last] = wanted[last];
      continue;
    }
    bound = wanted;
  }
}

void BoundedSystem::solveFree() {
  inner.clear();
  for (std::size_t i = 0; i < bound.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (bound[i] == 0)
      inner.push_back(k);
    else
      restX[k] = bound[i] < 0 ? restLower[k] : restUpper[k];
  }
  const auto n = static_cast<Eigen::Index>(inner.size());
  innerMatrix.resize(n, n);
  innerSide.resize(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Index kj = inner[static_cast<std::size_t>(j)];
    innerSide[j] = restSide[kj];
    for (std::size_t i = 0; i < bound.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (bound[i] != 0) innerSide[j] -= (kj >= k ? rest(kj, k) : rest(k, kj)) * restX[k];
    }
    for (Eigen::Index i = j; i < n; ++i) innerMatrix(i, j) = rest(inner[static_cast<std::size_t>(i)], kj);
  }
  if (n == 0) return;
  const InPlaceCholesky cholesky(innerMatrix);
  cholesky.matrixL().solveInPlace(innerSide);
  cholesky.matrixU().solveInPlace(innerSide);
  for (Eigen::Index j = 0; j < n; ++j) restX[inner[static_cast<std::size_t>(j)]] = innerSide[j];
}

}  // namespace plumbline::simulation
