#include "gap/inference/LinearResiduals.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "gap/inference/CellScale.h"
#include "gap/inference/Score.h"

namespace plumbline::gap {

namespace {

constexpr double priorWidth = 3;      // units
constexpr double mostFromMiddle = 4;  // of a strength from the middle, that its slope is trusted for [units]
constexpr int fitRounds = 2;          // of strengths and covariances in turn

/// Curvature of the prior of so many strengths.
Eigen::MatrixXd priorOf(std::size_t count) {
  const auto n = static_cast<Eigen::Index>(count);
  return Eigen::MatrixXd::Identity(n, n) / (priorWidth * priorWidth);
}

}  // namespace

bool StrengthSet::holds(std::size_t kind) const { return std::ranges::binary_search(kinds, kind); }

double StrengthSet::at(std::size_t kind) const {
  const auto found = std::ranges::lower_bound(kinds, kind);
  return found != kinds.end() && *found == kind ? x[found - kinds.begin()] : 0;
}

double SetScore::score() const { return std::accumulate(density.begin(), density.end(), -price); }

double logPrior(const Eigen::VectorXd& x) { return -x.squaredNorm() / (2 * priorWidth * priorWidth); }

/// Normal equations of one set, per group, in strengths themselves.
struct LinearResiduals::Equations {
  std::vector<Eigen::MatrixXd> information;
  std::vector<Eigen::VectorXd> right;
  /// Of all groups but one.
  std::pair<Eigen::MatrixXd, Eigen::VectorXd> sum(std::size_t leftOut) const {
    const auto n = right.front().size();
    std::pair<Eigen::MatrixXd, Eigen::VectorXd> all{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
    for (std::size_t g = 0; g < right.size(); ++g)
      if (g != leftOut) all.first += information[g], all.second += right[g];
    return all;
  }
};

LinearResiduals::LinearResiduals(const std::vector<CoefficientCell>& cells, std::size_t groups,
                                 const std::vector<CauseKind>& kinds, StrengthSet middle,
                                 Coefficients residuals, std::vector<Coefficients> slopes)
    : cells_(cells),
      groups_(groups),
      kinds_(kinds),
      middle_(std::move(middle)),
      residuals_(std::move(residuals)),
      slopes_(std::move(slopes)) {
  // Residuals at strengths of zero, so that every set is read off alike.
  for (std::size_t i = 0; i < middle_.kinds.size(); ++i)
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (const Eigen::MatrixXd& slope = slopes_[middle_.kinds[i]][c]; slope.size() > 0)
        residuals_[c] -= slope * middle_.x[static_cast<Eigen::Index>(i)];
}

Eigen::MatrixXd LinearResiduals::left(std::size_t cell, const std::vector<std::size_t>& kinds,
                                      const Eigen::VectorXd& x) const {
  Eigen::MatrixXd residuals = residuals_[cell];
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (const Eigen::MatrixXd& slope = slopes_[kinds[i]][cell]; slope.size() > 0)
      residuals += slope * x[static_cast<Eigen::Index>(i)];
  return residuals;
}

/// With the likeliest covariances for the residuals at these strengths.
LinearResiduals::Equations LinearResiduals::equations(const std::vector<std::size_t>& kinds,
                                                      const Eigen::VectorXd& at) const {
  const auto n = static_cast<Eigen::Index>(kinds.size());
  Equations equations{std::vector<Eigen::MatrixXd>(groups_, Eigen::MatrixXd::Zero(n, n)),
                      std::vector<Eigen::VectorXd>(groups_, Eigen::VectorXd::Zero(n))};
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    std::vector<Eigen::Index> felt;
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (slopes_[kinds[i]][c].size() > 0) felt.push_back(static_cast<Eigen::Index>(i));
    if (felt.empty()) continue;
    const CellScale scale = likeliestScale(left(c, kinds, at));
    const Eigen::LLT<Eigen::MatrixXd> factor(scale.covariance);
    const Eigen::VectorXd roots = (cells_[c].share * scale.weights).cwiseSqrt();
    const auto whitened = [&](const Eigen::MatrixXd& columns) {
      const Eigen::MatrixXd white = factor.matrixL().solve(columns * roots.asDiagonal());
      return Eigen::VectorXd(white.reshaped());
    };
    Eigen::MatrixXd design(residuals_[c].size(), static_cast<Eigen::Index>(felt.size()));
    for (std::size_t i = 0; i < felt.size(); ++i)
      design.col(static_cast<Eigen::Index>(i)) =
          whitened(slopes_[kinds[static_cast<std::size_t>(felt[i])]][c]);
    const std::size_t g = cells_[c].group;
    equations.information[g](felt, felt) += design.transpose() * design;
    equations.right[g](felt) -= design.transpose() * whitened(residuals_[c]);
  }
  return equations;
}

/// The strengths of least squares; a strength that would leave its bounds is held there.
Eigen::VectorXd LinearResiduals::solve(const std::vector<std::size_t>& kinds,
                                       const Eigen::MatrixXd& information,
                                       const Eigen::VectorXd& right) const {
  const auto n = static_cast<Eigen::Index>(kinds.size());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n), lower(n), upper(n);
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t kind = kinds[static_cast<std::size_t>(i)];
    lower[i] = std::max(kinds_[kind].lower, middle_.at(kind) - mostFromMiddle);
    upper[i] = std::min(kinds_[kind].upper, middle_.at(kind) + mostFromMiddle);
    free.push_back(i);
  }
  const Eigen::MatrixXd whole = information + priorOf(kinds.size());
  while (!free.empty()) {
    const Eigen::VectorXd rest = right(free) - whole(free, Eigen::all) * x;
    const Eigen::VectorXd solved = whole(free, free).llt().solve(rest);
    double worst = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < free.size(); ++i) {
      const double of = solved[static_cast<Eigen::Index>(i)];
      const double out = std::max(lower[free[i]] - of, of - upper[free[i]]);
      if (out > worst) worst = out, at = i;
    }
    if (worst == 0) {
      x(free) = solved;
      break;
    }
    const Eigen::Index held = free[at];
    x[held] = std::clamp(solved[static_cast<Eigen::Index>(at)], lower[held], upper[held]);
    free.erase(free.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return x;
}

Eigen::VectorXd LinearResiduals::startOf(const std::vector<std::size_t>& kinds) const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(kinds.size()));
  for (std::size_t i = 0; i < kinds.size(); ++i) x[static_cast<Eigen::Index>(i)] = middle_.at(kinds[i]);
  return x;
}

Eigen::VectorXd LinearResiduals::fit(const std::vector<std::size_t>& kinds) const {
  Eigen::VectorXd x = startOf(kinds);
  for (int round = 0; round < fitRounds && !kinds.empty(); ++round) {
    const auto [information, right] = equations(kinds, x).sum(groups_);
    x = solve(kinds, information, right);
  }
  return x;
}

SetScore LinearResiduals::score(const std::vector<std::size_t>& kinds) const {
  SetScore scored;
  scored.set = {kinds, fit(kinds)};
  scored.price = priceOf(kinds.size(), kinds_.size());
  for (const std::size_t kind : kinds) scored.price += kinds_[kind].price;
  const Equations of = equations(kinds, scored.set.x);
  scored.without.assign(groups_, scored.set.x);
  for (std::size_t g = 0; g < groups_ && !kinds.empty(); ++g) {
    const auto [information, right] = of.sum(g);
    scored.without[g] = solve(kinds, information, right);
  }
  scored.information = of.information;
  scored.density.assign(groups_, 0.0);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const std::size_t g = cells_[c].group;
    scored.density[g] += cells_[c].share * likeliestScale(left(c, kinds, scored.without[g])).density;
  }
  return scored;
}

std::vector<std::size_t> LinearResiduals::proposals(const StrengthSet& set, std::size_t most) const {
  const auto count = static_cast<Eigen::Index>(kinds_.size()), inSet = set.x.size();
  // Curvature of the log density by each kind and its slope at the set, and what it shares with those in it:
  // the equations() of all kinds together would grow with their square.
  Eigen::VectorXd curvatures = Eigen::VectorXd::Zero(count), slope = Eigen::VectorXd::Zero(count);
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(inSet, count), within = priorOf(set.kinds.size());
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Eigen::MatrixXd residuals = left(c, set.kinds, set.x);
    const CellScale scale = likeliestScale(residuals);
    const Eigen::LLT<Eigen::MatrixXd> factor(scale.covariance);
    const Eigen::VectorXd weights = cells_[c].share * scale.weights;
    const auto weighed = [&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd {
      return factor.solve(columns) * weights.asDiagonal();
    };
    const Eigen::MatrixXd pull = weighed(residuals);
    std::vector<Eigen::MatrixXd> of;
    for (const std::size_t kind : set.kinds)
      of.push_back(slopes_[kind][c].size() > 0 ? weighed(slopes_[kind][c]) : Eigen::MatrixXd());
    const auto product = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
      return a.cwiseProduct(b).sum();
    };
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::MatrixXd& way = slopes_[static_cast<std::size_t>(k)][c];
      if (way.size() == 0) continue;
      slope[k] -= product(pull, way);
      curvatures[k] += product(weighed(way), way);
      for (Eigen::Index i = 0; i < inSet; ++i)
        if (const Eigen::MatrixXd& other = of[static_cast<std::size_t>(i)]; other.size() > 0)
          shared(i, k) += product(other, way);
    }
  }
  for (Eigen::Index i = 0; i < inSet; ++i)
    within.col(i) += shared.col(static_cast<Eigen::Index>(set.kinds[static_cast<std::size_t>(i)]));
  const Eigen::LLT<Eigen::MatrixXd> inside(within);
  std::vector<std::pair<double, std::size_t>> gains;
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto kind = static_cast<std::size_t>(k);
    if (set.holds(kind) || !(curvatures[k] > 0)) continue;
    double curvature = curvatures[k] + 1 / (priorWidth * priorWidth);
    if (inSet > 0) {
      const Eigen::VectorXd with = shared.col(k);
      curvature -= with.dot(inside.solve(with));
    }
    const double way = std::clamp(slope[k] / curvature, std::max(kinds_[kind].lower, -mostFromMiddle),
                                  std::min(kinds_[kind].upper, mostFromMiddle));
    gains.emplace_back(slope[k] * way - curvature * way * way / 2, kind);
  }
  std::ranges::stable_sort(gains, std::ranges::greater(), [](const auto& gain) { return gain.first; });
  std::vector<std::size_t> best;
  for (const auto& [gain, kind] : gains)
    if (gain > 0 && best.size() < most) best.push_back(kind);
  return best;
}

}  // namespace plumbline::gap
