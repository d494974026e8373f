#include "gap/diagnosis/FineSteps.h"

#include <algorithm>
#include <cstddef>

#include "framework/Parallel.h"
#include "gap/diagnosis/Explanation.h"
#include "gap/diagnosis/Noise.h"

namespace plumbline::gap {

namespace {

constexpr double converged = 1.0 / 7;  // mean square of what half the step changes, in units of noise
constexpr int halvings = 3;

ReplayOptions halved(ReplayOptions options) {
  options.step /= 2;
  options.gearStep /= 2;
  return options;
}

/// The largest mean square, over noise, of any channel that two predictions of a trial differ by.
double difference(const Evidence& evidence, std::size_t t, const Prediction& a, const Prediction& b) {
  double most = 0;
  for (std::size_t s = 0; s < a.values.size(); ++s) {
    if (!Evidence::counts(evidence.trials()[t].signals[s])) continue;
    double sum = 0, n = 0;
    evidence.forEach(t, s, a, [&](std::size_t k, double w, double) {
      const double d = a.values[s][k] - b.values[s][k];
      sum += w * d * d;
      ++n;
    });
    if (n > 0) most = std::max(most, sum / n);
  }
  return most;
}

}  // namespace

ReplayOptions fineSteps(const Evidence& evidence, int jobs) {
  const std::vector<Trial>& trials = evidence.trials();
  std::vector<std::size_t> which;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const auto repeats = [&](std::size_t other) { return isRepeat(trials[other], trials[t]); };
    if (!trials[t].freeBase && std::ranges::none_of(which, repeats)) which.push_back(t);
  }
  ReplayOptions options;
  for (int halving = 0; halving < halvings; ++halving) {
    const ReplayOptions shorter = halved(options);
    std::vector<double> change(which.size());
    parallel(which.size(), jobs, [&](std::size_t i) {
      const Trial& trial = trials[which[i]];
      const Plant plant = plantOf(trial, {});
      change[i] =
          difference(evidence, which[i], replay(plant, trial, options), replay(plant, trial, shorter));
    });
    if (std::ranges::all_of(change, [](double c) { return c <= converged; })) break;
    options = shorter;
  }
  return options;
}

}  // namespace plumbline::gap
