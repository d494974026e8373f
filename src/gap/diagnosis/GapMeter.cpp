#include "gap/diagnosis/GapMeter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "gap/diagnosis/DeviatingJoints.h"

namespace plumbline::gap {

namespace {

constexpr double minExcess = 0.35;  // mean square beyond noise from which a channel counts
constexpr double minFixedBaseShare =
    0.1;  // of the excess on the feet: with less, runs on a fixed base do not decide
constexpr double mostBlocks = 0.8;  // on the feet: the rest may come after a foot that slipped
// For a joint that sticks. If one let go too late in MuJoCo, 2.8 % of the half-seconds deviated; with a cause
// outside the library, 15 % and more.
constexpr double stuckBlocks = 0.03;

/// Mean square over noise of each half-second in which a channel was compared, by the channel's name.
std::map<std::string, std::vector<double>> squaresByBlock(const Evaluator& evaluator, bool floatingBase) {
  struct Sum {
    double squares = 0, n = 0;
  };
  std::map<std::string, std::map<std::size_t, Sum>> sums;
  const Evidence& data = evaluator.evidence();
  for (std::size_t t = 0; t < data.trials().size(); ++t) {
    const Trial& trial = data.trials()[t];
    for (std::size_t s = 0; s < trial.signals.size() && trial.freeBase == floatingBase; ++s) {
      if (!Evidence::counts(trial.signals[s])) continue;
      auto& blocks = sums[trial.signals[s].name];
      data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t k, double w, double r) {
        Sum& sum = blocks[data.block(t, k)];
        sum.squares += w * r * r;
        ++sum.n;
      });
    }
  }
  std::map<std::string, std::vector<double>> result;
  for (const auto& [name, blocks] : sums)
    for (const auto& [block, sum] : blocks) result[name].push_back(sum.squares / sum.n);
  return result;
}

}  // namespace

WorstGap worstGap(const Evaluator& evaluator, std::optional<bool> floatingBase) {
  WorstGap worst;
  evaluator.forEachChannel([&](const Trial& trial, const Signal& signal, double chi) {
    if ((floatingBase && trial.freeBase != *floatingBase) || !Evidence::counts(signal)) return;
    const double size = std::sqrt(std::max(0.0, chi - 1));
    if (size > worst.size) worst = {size, signal.name};
  });
  return worst;
}

double gapOnFloatingBase(const Evaluator& evaluator) {
  double worst = 0;
  for (auto& [name, squares] : squaresByBlock(evaluator, true)) {
    const auto at =
        squares.begin() + static_cast<std::ptrdiff_t>(mostBlocks * static_cast<double>(squares.size() - 1));
    std::ranges::nth_element(squares, at);
    worst = std::max(worst, std::sqrt(std::max(0.0, *at - 1)));
  }
  return worst;
}

double gapOnFixedBase(const Evaluator& evaluator) {
  std::set<std::string> sticking;
  for (const Cause& cause : evaluator.base())
    if (cause.effect->sticks) sticking.insert("pos." + cause.place.at);
  for (const Mechanism::Joint& joint : evaluator.mechanism().joints)
    if (joint.friction > 0) sticking.insert("pos." + joint.name);
  double worst = 0;
  evaluator.forEachChannel([&](const Trial& trial, const Signal& signal, double chi) {
    if (!trial.freeBase && Evidence::counts(signal) && !sticking.contains(signal.name))
      worst = std::max(worst, std::sqrt(std::max(0.0, chi - 1)));
  });
  if (sticking.empty()) return worst;
  for (auto& [name, squares] : squaresByBlock(evaluator, false)) {
    if (!sticking.contains(name)) continue;
    std::ranges::sort(squares);
    squares.resize(squares.size() -
                   static_cast<std::size_t>(stuckBlocks * static_cast<double>(squares.size())));
    const double mean =
        std::accumulate(squares.begin(), squares.end(), 0.0) / static_cast<double>(squares.size());
    worst = std::max(worst, std::sqrt(std::max(0.0, mean - 1)));
  }
  return worst;
}

bool fixedBaseDecides(const Evaluator& evaluator) {
  const double fixed = std::ranges::max(jointExcess(evaluator, false)),
               floating = std::ranges::max(jointExcess(evaluator, true));
  return fixed >= minFixedBaseShare * floating;
}

WorstGap worstRestOffset(const Evaluator& evaluator) {
  struct Sum {
    double residual = 0, n = 0;
  };
  std::map<std::string, Sum> sums;
  const Evidence& data = evaluator.evidence();
  for (std::size_t t = 0; t < data.trials().size(); ++t) {
    const Trial& trial = data.trials()[t];
    for (std::size_t s = 0; s < trial.signals.size() && !trial.freeBase; ++s) {
      const SignalKind kind = trial.signals[s].kind;
      if (kind != SignalKind::gyro && kind != SignalKind::accelerometer) continue;
      Sum& sum = sums[trial.signals[s].name];
      data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t, double w, double r) {
        sum.residual += std::sqrt(w) * r;
        ++sum.n;
      });
    }
  }
  WorstGap worst;
  for (const auto& [name, sum] : sums)
    if (sum.n > 0 && std::abs(sum.residual) / sum.n > worst.size)
      worst = {std::abs(sum.residual) / sum.n, name};
  return worst;
}

GapMeter::GapMeter(const Evaluator& nominal) {
  const auto& trials = nominal.evidence().trials();
  bool any = false;
  for (const double least : {minExcess, -HUGE_VAL}) {
    counted_.assign(trials.size(), {});
    for (std::size_t t = 0; t < trials.size(); ++t)
      for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
        const double chi = nominal.chi(t, s);
        counted_[t].push_back(Evidence::counts(trials[t].signals[s]) && std::isfinite(chi) &&
                              chi - 1 > least);
        any = any || counted_[t].back();
      }
    if (any) break;
  }
}

double GapMeter::under(const Evaluator& evaluator) const {
  const Evidence& data = evaluator.evidence();
  double sum = 0, n = 0;
  for (std::size_t t = 0; t < counted_.size(); ++t)
    for (std::size_t s = 0; s < counted_[t].size(); ++s) {
      if (!counted_[t][s]) continue;
      data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t k, double w, double r) {
        if (Evidence::forFitting(data.block(t, k))) return;
        sum += w * r * r;
        ++n;
      });
    }
  return n > 0 ? std::sqrt(sum / n) : 0;
}

}  // namespace plumbline::gap
