#include "gap/inference/CommandLosses.h"

#include <algorithm>
#include <cmath>

#include "framework/Parallel.h"
#include "gap/diagnosis/LostCycles.h"
#include "gap/inference/Density.h"
#include "gap/inference/Likelihood.h"
#include "gap/inference/Score.h"
#include "gap/inference/Unexplained.h"
#include "math/Random.h"
#include "math/WilsonInterval.h"

namespace plumbline::gap {

namespace {

constexpr int sharesTried = 2;
// Of a loss, of the sum of squares: that of a share of 27 %. So large shares are not known well enough for
// less.
constexpr double leastPrice = 2;

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

/// What residuals gain in log density over others that are slower, as those of lost commands are. The slow
/// part of n residuals is n / T independent values with T times their variance. T is the longer of the two
/// correlation times. With equal ones this is the difference of densities().
double gainOver(const Groups& groups, const Residuals& left, const Residuals& before) {
  const Shares sharesLeft = sharesOf(groups, left), sharesBefore = sharesOf(groups, before);
  double gain = 0;
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    const Cell& cell = groups.cells()[c];
    const Series &seriesLeft = left[cell.trial][cell.signal], &seriesBefore = before[cell.trial][cell.signal];
    if (!seriesLeft || !seriesBefore) continue;
    const StretchFit a = seriesLeft->fitOf(cell.from, cell.to, cell.noise),
                     b = seriesBefore->fitOf(cell.from, cell.to, cell.noise);
    const double timeLeft = timeOfScale(1 / sharesLeft[c], a.scale, a.noise),
                 timeBefore = timeOfScale(1 / sharesBefore[c], b.scale, b.noise),
                 longer = std::max(timeLeft, timeBefore);
    gain += a.density(1 / longer) - b.density(1 / longer) +
            a.samples / longer * std::log(timeBefore / timeLeft) / 2;
  }
  return gain;
}

}  // namespace

double CommandLosses::share(const std::vector<char>& wanted) const {
  const auto of = static_cast<double>(sumOf(seen, wanted));
  return of > 0 ? std::min(1.0, static_cast<double>(sumOf(found, wanted)) / of / recovered) : 0;
}

Bounds CommandLosses::interval() const {
  const auto here = static_cast<double>(sumOf(found, {})), of = static_cast<double>(sumOf(seen, {})),
             simulated = static_cast<double>(foundInSimulation);
  // Relative variances of counts add up.
  const double part = simulated > 0 ? simulated / (here + simulated) : 1;
  const auto [lower, upper] = wilsonInterval(part * here, part * of);
  return {lower / recovered, std::min(1.0, upper / recovered)};
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
  const Evidence evidence(sent, std::move(noises));
  double price = LostCycles::surePrice;
  LostCycles decoded = findLostCycles(evidence, causes, jobs, price);
  // Where many are lost, less evidence is enough for each: the price is that of the share found. One that
  // shows at once is found with either.
  for (int round = 0; round < sharesTried && decoded.slow && decoded.share > 0; ++round) {
    const double before = price;
    price = std::clamp(2 * std::log((1 - decoded.share) / decoded.share), leastPrice, LostCycles::surePrice);
    if (price == before) break;
    LostCycles again = findLostCycles(evidence, causes, jobs, price);
    if (again.share <= decoded.share) break;
    decoded = std::move(again);
  }
  CommandLosses lost;
  lost.cycles = std::move(decoded.cycles);
  lost.seen = std::move(decoded.seenIn);
  lost.found = std::move(decoded.foundIn);
  return lost;
}

void measureRecovery(CommandLosses& lost, const std::vector<Trial>& sent, const Groups& groups,
                     const Explanation& causes, int jobs) {
  constexpr std::uint64_t seed = 1;
  const double share = lost.share();
  std::vector<Trial> simulated = sent;
  double drawn = 0, cycles = 0;
  for (std::size_t t = 0; t < simulated.size(); ++t) {
    Trial& trial = simulated[t];
    if (trial.freeBase) continue;
    Random random(seed + t);
    std::vector<std::uint8_t> other(trial.cycles(), 0);
    for (auto& cycle : other) {
      cycle = random.uniform() < share;
      drawn += cycle;
      ++cycles;
    }
    ReplayOptions options;
    options.lostCycles = &other;
    const Prediction shown = replay(plantOf(trial, causes), trial, options);
    for (std::size_t s = 0; s < trial.signals.size(); ++s)
      for (std::size_t k = 0; k < trial.cycles() && !shown.values[s].empty(); ++k)
        trial.signals[s].values[k] =
            shown.values[s][k] + groups.uses()[t][s].readingNoise * random.gaussian();
  }
  const CommandLosses again = decodeLostCommands(simulated, groups, causes, jobs);
  if (!again.any() || drawn == 0) return;
  lost.recovered = again.share() / (drawn / cycles);
  lost.foundInSimulation = sumOf(again.found, {});
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
                  const Explanation& asSent, std::size_t kinds) {
  const Groups& groups = known.groups();
  ReplayOptions allArrive;
  allArrive.asSent = true;
  const Replayer sent(known.mechanism(), groups, known.jobs(), allArrive);
  std::vector<char> fixed;
  for (const Trial& trial : groups.trials()) fixed.push_back(!trial.freeBase);
  const double gain = gainOver(groups, known.residuals(causes, fixed), sent.residuals(asSent, fixed));
  return gain + priceOf(asSent.size(), kinds) - priceOf(causes.size() + 1, kinds) -
         priceOfCycles(static_cast<double>(sumOf(lost.found, {})), static_cast<double>(sumOf(lost.seen, {})));
}

}  // namespace plumbline::gap
