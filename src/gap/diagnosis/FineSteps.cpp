#include "gap/diagnosis/FineSteps.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "framework/Parallel.h"
#include "gap/diagnosis/Explanation.h"
#include "gap/diagnosis/Noise.h"

namespace plumbline::gap {

namespace {

constexpr double converged = 0.378;  // of its noise: what half the step changes in a channel, at most
constexpr int halvings = 3;

ReplayOptions halved(ReplayOptions options) {
  options.step /= 2;
  options.gearStep /= 2;
  return options;
}

}  // namespace

ReplayOptions fineSteps(const Evidence& evidence, int jobs) {
  const std::vector<Trial>& trials = evidence.trials();
  std::vector<std::size_t> which;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const auto repeats = [&](std::size_t other) { return isRepeat(trials[other], trials[t]); };
    if (!trials[t].freeBase && std::ranges::none_of(which, repeats)) which.push_back(t);
  }
  std::vector<Prediction> predictions(which.size());
  const auto play = [&](std::size_t i, const ReplayOptions& options) {
    const Trial& trial = trials[which[i]];
    return replay(plantOf(trial, {}), trial, options);
  };
  ReplayOptions options;
  parallel(which.size(), jobs, [&](std::size_t i) { predictions[i] = play(i, options); });
  for (int halving = 0; halving < halvings; ++halving) {
    const ReplayOptions shorter = halved(options);
    std::vector<double> change(which.size());
    parallel(which.size(), jobs, [&](std::size_t i) {
      Prediction finer = play(i, shorter);
      change[i] = evidence.difference(which[i], predictions[i], finer);
      predictions[i] = std::move(finer);
    });
    if (std::ranges::all_of(change, [](double c) { return c <= converged; })) break;
    options = shorter;
  }
  return options;
}

}  // namespace plumbline::gap
