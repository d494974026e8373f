#include "gap/diagnosis/LostCycles.h"

#include <algorithm>
#include <cmath>

namespace plumbline::gap {

namespace {

constexpr std::size_t spacing =
    10;                           // cycles between two that are tried in one replay: a servo settles within
constexpr std::size_t reach = 4;  // cycles within which only one changes its mind in a round
constexpr int rounds = 8;
constexpr double leastGain = 14;  // of the sum of squares: e^-7 by chance, in thousands of cycles
constexpr double visibleChange = 4 * leastGain;

}  // namespace

LostCycles findLostCycles(const Mechanism& mechanism, const Evidence& evidence, const Explanation& causes) {
  LostCycles result;
  const Plant plant = plantOf(mechanism, causes);
  for (std::size_t t = 0; t < evidence.trials().size(); ++t) {
    const Trial& trial = evidence.trials()[t];
    auto& lost = result.cycles.emplace_back();
    if (trial.freeBase) continue;
    lost.assign(trial.cycles(), 0);
    std::vector<double> seen(trial.cycles(), 0);
    std::vector<double> gains(trial.cycles());
    for (int round = 0; round < rounds; ++round) {
      ReplayOptions options;
      options.lostCycles = &lost;
      const Prediction base = replay(plant, trial, options);
      for (std::size_t offset = 0; offset < spacing; ++offset) {
        std::vector<std::uint8_t> tried = lost;
        for (std::size_t k = offset; k < tried.size(); k += spacing) tried[k] ^= 1;
        options.lostCycles = &tried;
        const Prediction other = replay(plant, trial, options);
        for (std::size_t k = offset; k < tried.size(); k += spacing) {
          double gain = 0, change = 0;
          for (std::size_t s = 0; s < trial.signals.size(); ++s) {
            if (trial.signals[s].joint < 0 || base.values[s].empty()) continue;
            const auto& weights = evidence.weights(t, s);
            for (std::size_t i = k + 1; i < std::min(k + spacing, trial.cycles()); ++i) {
              if (weights[i] <= 0 || !std::isfinite(base.values[s][i])) continue;
              const double r = trial.signals[s].values[i] - base.values[s][i];
              const double d = other.values[s][i] - base.values[s][i];
              gain += weights[i] * (2 * r * d - d * d);
              change += weights[i] * d * d;
            }
          }
          seen[k] = change;
          gains[k] = gain - (lost[k] ? 0 : leastGain);
        }
      }
      // Neighbours explain much of the same: in each round only the best of them changes.
      bool any = false;
      const std::vector<std::uint8_t> before = lost;
      for (std::size_t k = 0; k < gains.size(); ++k) {
        if (gains[k] <= 0) continue;
        const std::size_t from = k >= reach ? k - reach : 0, to = std::min(k + reach + 1, gains.size());
        bool best = true;
        for (std::size_t i = from; i < to; ++i)
          best = best && (gains[i] < gains[k] || i == k || (gains[i] == gains[k] && i > k));
        if (!best) continue;
        lost[k] = before[k] ^ 1;
        any = true;
      }
      if (!any) break;
    }
    for (std::size_t k = 0; k < lost.size(); ++k) {
      if (seen[k] < visibleChange) continue;
      ++result.visible;
      result.found += lost[k];
    }
  }
  result.share = result.visible ? static_cast<double>(result.found) / static_cast<double>(result.visible) : 0;
  return result;
}

}  // namespace plumbline::gap
