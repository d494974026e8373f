#include "gap/inference/StrengthFit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gap/inference/CellScale.h"
#include "gap/inference/Groups.h"

namespace plumbline::gap {

namespace {

constexpr double shareOfStrength = 0.25;  // step of derivatives, of a strength that is at least half a unit
constexpr double vanished = 1e-3;         // units
constexpr double leastGained = 0.05;      // of log density, that a step is worth
constexpr double leastStep = 0.01;        // of a sweep [units]

}  // namespace

StrengthFitter::StrengthFitter(const CoefficientReplayer& replayer, const std::vector<CauseKind>& configured)
    : replayer_(replayer), kinds_(replayer.kinds()) {
  kinds_.insert(kinds_.end(), configured.begin(), configured.end());
}

StrengthSet StrengthFitter::setOf(const Explanation& causes) const {
  StrengthSet set;
  for (const Cause& cause : causes)
    // From the last on: those that were configured go before the replayer's own.
    for (std::size_t kind = kinds_.size(); kind-- > 0;) {
      const Cause& of = kinds_[kind].cause;
      if (!of.sameForm(cause) || of.inactiveIn != cause.inactiveIn || set.holds(kind)) continue;
      set = with(set, kind);
      set.x[std::ranges::lower_bound(set.kinds, kind) - set.kinds.begin()] =
          cause.effect->strengthOf(cause.value) / kinds_[kind].unit;
      break;
    }
  return set;
}

std::vector<std::size_t> StrengthFitter::all() const {
  std::vector<std::size_t> every(kinds_.size());
  std::iota(every.begin(), every.end(), std::size_t{0});
  return every;
}

Explanation StrengthFitter::causesOf(const StrengthSet& set) const {
  Explanation causes;
  for (std::size_t i = 0; i < set.kinds.size(); ++i)
    causes.push_back(
        causeAt(replayer_.mechanism(), kinds_[set.kinds[i]], set.x[static_cast<Eigen::Index>(i)]));
  return causes;
}

double StrengthFitter::density(const StrengthSet& set) const {
  const Coefficients residuals = replayer_.coefficients(causesOf(set));
  double sum = logPrior(set.x);
  for (std::size_t c = 0; c < residuals.size(); ++c)
    sum += replayer_.cells()[c].share * likeliestScale(residuals[c]).density;
  return sum;
}

bool StrengthFitter::exclude(std::size_t a, std::size_t b) const {
  const Cause &one = kinds_[a].cause, &other = kinds_[b].cause;
  return a != b && one.effect == other.effect && one.place == other.place;
}

/// Large enough to average out what starts or ends at single steps of a replay (sticking).
double StrengthFitter::stepOf(const StrengthSet& set, std::size_t kind) const {
  const CauseKind& of = kinds_[kind];
  if (!set.holds(kind)) return of.upper >= 1 ? 1 : of.lower <= -1 ? -1 : std::max(of.upper, -of.lower);
  const double x = set.at(kind), step = shareOfStrength * std::max(std::abs(x), 0.5);
  return x + step <= of.upper ? step : -step;
}

void StrengthFitter::slopesOf(const StrengthSet& set, const Coefficients& here,
                              const std::vector<std::size_t>& wanted,
                              std::vector<Coefficients>& slopes) const {
  const std::vector<CoefficientCell>& cells = replayer_.cells();
  for (const std::vector<std::size_t>& colour : colours(kinds_, wanted)) {
    StrengthSet moved = set;
    for (const std::size_t kind : colour) {
      if (!moved.holds(kind)) moved = with(moved, kind);
      moved.x[std::ranges::lower_bound(moved.kinds, kind) - moved.kinds.begin()] += stepOf(set, kind);
    }
    const Coefficients there = replayer_.coefficients(causesOf(moved));
    for (const std::size_t kind : colour) {
      const std::vector<int>& joints = kinds_[kind].joints;
      Coefficients& of = slopes[kind];
      bool visible = set.holds(kind);
      for (std::size_t c = 0; c < cells.size(); ++c) {
        of.emplace_back();
        if (!joints.empty() && std::ranges::find(joints, cells[c].joint) == joints.end()) continue;
        const Eigen::MatrixXd change = there[c] - here[c];
        if (change.isZero(0) || !change.allFinite()) continue;
        const CoefficientCell::Part& part = cells[c].columns.front();
        const double size = change.norm() / std::sqrt(static_cast<double>(change.cols()) *
                                                      static_cast<double>(part.to - part.from));
        visible = visible || size > enginesDiffer;
        of.back() = change / stepOf(set, kind);
      }
      if (!visible) of.assign(cells.size(), {});
    }
  }
}

LinearResiduals StrengthFitter::linearise(const StrengthSet& set,
                                          const std::vector<std::size_t>& wanted) const {
  std::vector<Coefficients> slopes(kinds_.size());
  std::vector<std::size_t> plain;
  std::vector<std::vector<std::size_t>> instead(set.kinds.size());
  for (const std::size_t kind : wanted) {
    std::size_t i = 0;
    while (i < set.kinds.size() && !exclude(kind, set.kinds[i])) ++i;
    (i < set.kinds.size() ? instead[i] : plain).push_back(kind);
  }
  Coefficients here = replayer_.coefficients(causesOf(set));
  slopesOf(set, here, plain, slopes);
  for (std::size_t i = 0; i < instead.size(); ++i)
    if (!instead[i].empty()) {
      const StrengthSet rest = gap::without(set, set.kinds[i]);
      slopesOf(rest, replayer_.coefficients(causesOf(rest)), instead[i], slopes);
    }
  for (Coefficients& of : slopes)
    if (of.empty()) of.resize(replayer_.cells().size());
  return LinearResiduals(replayer_.cells(), replayer_.groups().count(), kinds_, set, std::move(here),
                         std::move(slopes));
}

double StrengthFitter::step(StrengthSet& set, double now) const {
  const Eigen::VectorXd way = linearise(set, set.kinds).fit(set.kinds) - set.x;
  double share = 1;
  for (int attempt = 0; attempt < 4; ++attempt, share /= 3) {
    StrengthSet next{set.kinds, set.x + share * way};
    const double there = density(next);
    if (!(there > now)) continue;
    set = std::move(next);
    return there;
  }
  return now;
}

double StrengthFitter::sweep(StrengthSet& set, double now, Eigen::VectorXd& steps) const {
  for (Eigen::Index i = 0; i < set.x.size(); ++i) {
    const CauseKind& kind = kinds_[set.kinds[static_cast<std::size_t>(i)]];
    bool better = false;
    for (const double way : {steps[i], -steps[i]}) {
      StrengthSet next = set;
      next.x[i] = std::clamp(set.x[i] + way, kind.lower, kind.upper);
      const double there = density(next);
      if (!(there > now)) continue;
      set = std::move(next);
      now = there;
      steps[i] = way;  // the same way first when it comes to this one again
      better = true;
      break;
    }
    if (!better) steps[i] /= 3;
  }
  return now;
}

StrengthSet StrengthFitter::refine(StrengthSet set, int mostSteps) const {
  double now = density(set);
  Eigen::VectorXd steps = shareOfStrength * set.x.cwiseAbs().cwiseMax(0.5);
  for (int round = 0; round < mostSteps && !set.kinds.empty(); ++round) {
    const double before = now;
    now = step(set, now);
    if (now - before < leastGained) now = sweep(set, now, steps);
    if (now - before < leastGained && steps.cwiseAbs().maxCoeff() < leastStep) break;
  }
  for (std::size_t i = set.kinds.size(); i-- > 0;)
    if (std::abs(set.x[static_cast<Eigen::Index>(i)]) < vanished) set = gap::without(set, set.kinds[i]);
  return set;
}

StrengthSet with(const StrengthSet& set, std::size_t kind) {
  StrengthSet larger{set.kinds, Eigen::VectorXd::Zero(set.x.size() + 1)};
  const auto at = std::ranges::lower_bound(larger.kinds, kind) - larger.kinds.begin();
  larger.kinds.insert(larger.kinds.begin() + at, kind);
  larger.x.head(at) = set.x.head(at);
  larger.x.tail(set.x.size() - at) = set.x.tail(set.x.size() - at);
  return larger;
}

StrengthSet without(const StrengthSet& set, std::size_t kind) {
  StrengthSet smaller{set.kinds, Eigen::VectorXd::Zero(set.x.size() - 1)};
  const auto at = std::ranges::lower_bound(smaller.kinds, kind) - smaller.kinds.begin();
  smaller.kinds.erase(smaller.kinds.begin() + at);
  smaller.x.head(at) = set.x.head(at);
  smaller.x.tail(smaller.x.size() - at) = set.x.tail(smaller.x.size() - at);
  return smaller;
}

}  // namespace plumbline::gap
