#include "gap/diagnosis/GapMeter.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "gap/diagnosis/Suspects.h"

namespace plumbline::gap {

namespace {

constexpr double shows = 0.35;      // mean square beyond noise from which a channel counts
constexpr double asFar = 0.1;       // of the excess on the feet: held runs that show as much tell the cause
constexpr double mostBlocks = 0.8;  // on the feet: the rest may have gone astray

}  // namespace

WorstGap worstGap(const Evaluator& evaluator, std::optional<bool> standing) {
  WorstGap worst;
  evaluator.forEachChannel([&](const Trial& trial, const Signal& signal, double chi) {
    if ((standing && trial.freeBase != *standing) || !Evidence::counts(signal)) return;
    const double size = std::sqrt(std::max(0.0, chi - 1));
    if (size > worst.size) worst = {size, signal.name};
  });
  return worst;
}

double gapOnFeet(const Evaluator& evaluator) {
  struct Sum {
    double squares = 0, n = 0;
  };
  std::map<std::string, std::map<std::size_t, Sum>> signals;  // per block
  const Evidence& data = evaluator.evidence();
  for (std::size_t t = 0; t < data.trials().size(); ++t) {
    const Trial& trial = data.trials()[t];
    for (std::size_t s = 0; s < trial.signals.size() && trial.freeBase; ++s) {
      if (!Evidence::counts(trial.signals[s])) continue;
      auto& blocks = signals[trial.signals[s].name];
      data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t k, double w, double r) {
        Sum& sum = blocks[data.block(t, k)];
        sum.squares += w * r * r;
        ++sum.n;
      });
    }
  }
  double worst = 0;
  for (const auto& [name, blocks] : signals) {
    std::vector<double> sizes;
    for (const auto& [block, sum] : blocks) sizes.push_back(sum.squares / sum.n);
    if (sizes.empty()) continue;
    const auto at =
        sizes.begin() + static_cast<std::ptrdiff_t>(mostBlocks * static_cast<double>(sizes.size() - 1));
    std::ranges::nth_element(sizes, at);
    worst = std::max(worst, std::sqrt(std::max(0.0, *at - 1)));
  }
  return worst;
}

bool heldRunsTell(const Evaluator& evaluator) {
  const double held = std::ranges::max(jointExcess(evaluator, false)),
               standing = std::ranges::max(jointExcess(evaluator, true));
  return held >= asFar * standing;
}

WorstGap worstHeldOffset(const Evaluator& evaluator) {
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
  for (const double least : {shows, -HUGE_VAL}) {
    counted.assign(trials.size(), {});
    for (std::size_t t = 0; t < trials.size(); ++t)
      for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
        const double chi = nominal.chi(t, s);
        counted[t].push_back(Evidence::counts(trials[t].signals[s]) && std::isfinite(chi) && chi - 1 > least);
        any = any || counted[t].back();
      }
    if (any) break;
  }
}

double GapMeter::under(const Evaluator& evaluator) const {
  const Evidence& data = evaluator.evidence();
  double sum = 0, n = 0;
  for (std::size_t t = 0; t < counted.size(); ++t)
    for (std::size_t s = 0; s < counted[t].size(); ++s) {
      if (!counted[t][s]) continue;
      data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t k, double w, double r) {
        if (Evidence::forFitting(data.block(t, k))) return;
        sum += w * r * r;
        ++n;
      });
    }
  return n > 0 ? std::sqrt(sum / n) : 0;
}

}  // namespace plumbline::gap
