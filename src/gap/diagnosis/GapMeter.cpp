#include "gap/diagnosis/GapMeter.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plumbline::gap {

namespace {

constexpr double shows = 0.35;  // mean square beyond noise from which a channel counts

}  // namespace

WorstGap worstGap(const Evaluator& evaluator, std::optional<bool> standing) {
  WorstGap worst;
  const auto& trials = evaluator.evidence().trials();
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const double chi = evaluator.chi(t, s);
      if (standing && trials[t].freeBase != *standing) continue;
      if (!Evidence::counts(trials[t].signals[s]) || !std::isfinite(chi)) continue;
      const double size = std::sqrt(std::max(0.0, chi - 1));
      if (size > worst.size) worst = {size, trials[t].signals[s].name};
    }
  return worst;
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
