#include "gap/inference/CommandLosses.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "framework/Parallel.h"
#include "gap/diagnosis/LostCycles.h"
#include "gap/inference/Score.h"
#include "gap/inference/Unexplained.h"
#include "math/WilsonInterval.h"

namespace plumbline::gap {

namespace {

std::size_t sumOf(const std::vector<std::size_t>& counts, const std::vector<char>& wanted) {
  std::size_t sum = 0;
  for (std::size_t t = 0; t < counts.size(); ++t)
    if (wanted.empty() || wanted[t]) sum += counts[t];
  return sum;
}

/// Minus the logarithm of the probability that just these cycles of so many are lost, with any share from 0
/// to 1 as likely: B(lost + 1, seen - lost + 1).
double priceOfCycles(double lost, double seen) {
  return std::lgamma(seen + 2) - std::lgamma(lost + 1) - std::lgamma(seen - lost + 1);
}

}  // namespace

double CommandLosses::share(const std::vector<char>& wanted) const {
  const auto of = static_cast<double>(sumOf(seen, wanted));
  return of > 0 ? static_cast<double>(sumOf(found, wanted)) / of : 0;
}

Bounds CommandLosses::interval() const {
  const auto [lower, upper] =
      wilsonInterval(static_cast<double>(sumOf(found, {})), static_cast<double>(sumOf(seen, {})));
  return {lower, upper};
}

Cause CommandLosses::cause(double share) {
  const auto effect = std::ranges::find(effects(), true, &Effect::decoded);
  return {*effect, Place{Site::everywhere, -1, std::string("*")}, share};
}

bool repeatsDiffer(const Groups& groups) {
  for (std::size_t t = 0; t < groups.trials().size(); ++t)
    for (const ChannelUse& use : groups.uses()[t])
      if (!groups.trials()[t].freeBase && use.used &&
          use.noise > std::hypot(1, leastUnexplained) * use.readingNoise)
        return true;
  return false;
}

bool mayHaveLostCommands(const Groups& groups) {
  const std::vector<Trial>& trials = groups.trials();
  bool fixed = false, repeated = false;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].freeBase) continue;
    fixed = true;
    for (std::size_t other = 0; other < t && !repeated; ++other)
      repeated = trials[other].recording != trials[t].recording && isRepeat(trials[other], trials[t]);
  }
  return fixed && (!repeated || repeatsDiffer(groups));
}

CommandLosses decodeLostCommands(const std::vector<Trial>& sent, const Groups& groups,
                                 const Explanation& causes, int jobs) {
  std::vector<std::vector<SignalNoise>> noises;
  for (const std::vector<ChannelUse>& uses : groups.uses()) {
    auto& of = noises.emplace_back();
    for (const ChannelUse& use : uses) of.push_back({use.readingNoise, use.readingNoise, false});
  }
  LostCycles decoded = findLostCycles(Evidence(sent, std::move(noises)), causes, jobs);
  CommandLosses lost;
  lost.cycles = std::move(decoded.cycles);
  lost.seen = std::move(decoded.seenIn);
  lost.found = std::move(decoded.foundIn);
  return lost;
}

std::vector<Trial> withLost(std::vector<Trial> trials, const CommandLosses& lost) {
  for (std::size_t t = 0; t < trials.size(); ++t) trials[t].lost = lost.cycles[t];
  return trials;
}

std::vector<Prediction> predictionsOf(const std::vector<Trial>& trials, const Explanation& causes, int jobs) {
  std::vector<Prediction> predictions(trials.size());
  parallel(trials.size(), jobs, [&](std::size_t t) {
    if (!trials[t].freeBase) predictions[t] = replay(plantOf(trials[t], causes), trials[t]);
  });
  return predictions;
}

double evidenceOf(const CommandLosses& lost, const Replayer& known, const Explanation& causes,
                  std::size_t kinds) {
  const Groups& groups = known.groups();
  ReplayOptions asSent;
  asSent.asSent = true;
  const Replayer sent(known.mechanism(), groups, known.jobs(), asSent);
  std::vector<char> fixed;
  for (const Trial& trial : groups.trials()) fixed.push_back(!trial.freeBase);
  const Residuals left = known.residuals(causes, fixed), before = sent.residuals(causes, fixed);
  const Shares shares = sharesOfBoth(groups, left, before);
  const std::vector<double> with = densities(groups, left, shares),
                            without = densities(groups, before, shares);
  const double gain =
      std::accumulate(with.begin(), with.end(), 0.0) - std::accumulate(without.begin(), without.end(), 0.0);
  return gain - priceOf(1, kinds) -
         priceOfCycles(static_cast<double>(sumOf(lost.found, {})), static_cast<double>(sumOf(lost.seen, {})));
}

}  // namespace plumbline::gap
