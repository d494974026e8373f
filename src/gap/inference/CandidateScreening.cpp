#include "gap/inference/CandidateScreening.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "gap/inference/Groups.h"
#include "gap/inference/Likelihood.h"
#include "gap/inference/MostToGain.h"
#include "gap/inference/PossibleKinds.h"
#include "gap/inference/Score.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostGuessed = 24;  // kinds whose gain is worked out and not only guessed
constexpr std::size_t mostClimbed = 36;  // kinds of which more is replayed
constexpr std::size_t finerOnFeet = 4;   // times as many samples, because feet slip and land
constexpr double mostFactor = 4;         // of a start, up and down, that its sensitivity is trusted for
constexpr double mostOfSticking = 1.4;   // the same, where a joint sticks
constexpr double leastOfLinear = 0.02;   // of the start of an effect whose change is in proportion to it

/// Every n-th value of a stretch; the n-th of the whole series, wherever the stretch begins.
std::vector<double> thinned(const ResidualSeries& values, std::size_t from, std::size_t to,
                            std::size_t every) {
  std::vector<double> result;
  for (std::size_t k = (from + every - 1) / every * every; k < std::min(to, values.size()); k += every)
    result.push_back(values[k]);
  return result;
}

/// Whether one is the other with the opposite sign, and its change is the opposite too.
bool isOpposite(const Cause& one, const Cause& other) {
  const double a = one.effect->strengthOf(one.value), b = other.effect->strengthOf(other.value);
  return one.effect->linear && std::abs(a + b) <= 1e-6 * std::abs(a);
}

}  // namespace

/// Thinned residual of a base in a cell, with the sums that a guess needs.
struct CandidateScreening::Left {
  struct OfCell {
    Cell cell;
    std::size_t first = 0;  ///< of the thinned values of its trial
    double share = 1;       ///< of one value that is looked at
    std::vector<double> values;
    Split parts;
    std::vector<double> weights;  ///< of what varies; 0 where nothing was measured
    double scale = 0, density = 0, squares = 0, count = 0;
    bool sparse = false;  ///< a few values alone are off, of which squares say nothing

    /// Of log density, without a factor of a change.
    double gain(const float* change, double factor) const {
      std::vector<double> r = values;
      for (std::size_t k = 0; k < r.size(); ++k) r[k] -= factor * static_cast<double>(change[k]);
      return stretchDensity(split(r), cell.noise, share) - density;
    }
  };
  std::vector<OfCell> cells;
  std::vector<std::vector<std::vector<std::size_t>>> at;  ///< cells per trial and signal
};

struct CandidateScreening::Guessed {
  /// toNoise: without the part below the noise. A cause that explains nothing above it would only compensate
  /// for how the replay is computed.
  double gain = 0, toNoise = 0;
  double share = 1;  ///< of the start's strength, that gains most
};

struct CandidateScreening::Worth {
  Cause cause;
  std::vector<char> trials;  ///< flags: looked at there first
};

CandidateScreening::CandidateScreening(const Replayer& replayer, const Shares& shares,
                                       const ScreeningOptions& options) {
  const Groups& groups = replayer.groups();
  const Mechanism& robot = replayer.mechanism();
  // If leaving others out leaves one recording only, it is cut into stretches.
  const std::size_t stretches = groups.count() <= 2 || groups.stretchesOfOne() ? 4 : 1;
  for (const Trial& trial : groups.trials()) {
    const std::size_t enough = (trial.freeBase ? finerOnFeet : stretches) * enoughSamples;
    every_.push_back(std::max<std::size_t>(1, trial.cycles() / enough));
  }
  const std::vector<Cause> possible = possibleKinds(groups, robot);
  kinds_ = possible.size();
  const MostToGain most(replayer, shares, kinds_);
  std::vector<Worth> worth;
  looked_.assign(groups.trials().size(), 0);
  for (const Trial& trial : groups.trials()) onFeet_.push_back(trial.freeBase);
  for (const Cause& cause : possible) {
    if (std::ranges::any_of(replayer.base(), [&](const Cause& known) { return known.sameKind(cause); }))
      continue;
    std::vector<char> trials = most.trialsFor(cause);
    if (std::ranges::find(trials, 1) == trials.end()) continue;
    std::ranges::transform(looked_, trials, looked_.begin(), std::bit_or());
    worth.push_back({cause, std::move(trials)});
  }
  // On the feet long steps slip at other moments.
  const bool anyOnFeet = std::ranges::find(onFeet_, 1) != onFeet_.end();
  const Replayer quick(robot, groups, replayer.jobs(), anyOnFeet ? ReplayOptions() : withLongSteps(),
                       replayer.base());
  const Residuals left = quick.residuals({}, looked_);
  replayStarts(quick, left, worth, options);
  replayFurtherStrengths(quick, left, shares);
  replayElsewhere(quick, left, shares);
}

/// Difference of the residuals of two replays, thinned, in the signals that are used; none where they are
/// equal.
std::vector<CandidateScreening::Change> CandidateScreening::changesOf(const Groups& groups,
                                                                      const Residuals& nominal,
                                                                      const Residuals& with,
                                                                      const std::vector<char>& looked) const {
  std::vector<Change> changes;
  for (std::size_t t = 0; t < groups.trials().size(); ++t)
    for (std::size_t s = 0; s < groups.trials()[t].signals.size() && looked[t]; ++s) {
      if (!groups.uses()[t][s].used || with[t][s] == nominal[t][s]) continue;
      const std::size_t cycles = groups.trials()[t].cycles();
      const std::vector<double> a = thinned(*nominal[t][s], 0, cycles, every_[t]),
                                b = thinned(*with[t][s], 0, cycles, every_[t]);
      Change change{t, s, {}};
      bool any = false;
      for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        const double d = a[k] - b[k];
        change.values.push_back(std::isfinite(d) ? static_cast<float>(d) : 0.F);
        any = any || change.values.back() != 0;
      }
      if (any) changes.push_back(std::move(change));
    }
  return changes;
}

void CandidateScreening::replayStarts(const Replayer& replayer, const Residuals& nominal,
                                      const std::vector<Worth>& worth, const ScreeningOptions& options) {
  const Mechanism& robot = replayer.mechanism();
  for (std::size_t i = 0; i < worth.size(); ++i) {
    if (options.progress) options.progress(static_cast<double>(i) / static_cast<double>(worth.size()));
    const auto& [kind, trials] = worth[i];
    const std::size_t firstOfKind = starts_.size();
    for (Cause cause : startsOf(robot, kind)) {
      if (options.startFor) {
        const std::optional<Cause> other = options.startFor(cause);
        if (!other) continue;
        cause = *other;
      }
      Start start{cause, trials, {}};
      if (starts_.size() > firstOfKind && isOpposite(starts_[firstOfKind].cause, cause)) {
        start.changes = starts_[firstOfKind].changes;
        for (Change& change : start.changes)
          for (float& of : change.values) of = -of;
      } else {
        start.changes = changesOf(replayer.groups(), nominal, replayer.residuals({cause}, trials), trials);
      }
      if (!start.changes.empty()) starts_.push_back(std::move(start));
    }
  }
}

namespace {

/// The effect of a start's change in one cell.
struct Sums {
  double share, count, least, squares;  ///< of the cell; least: (noise / scale)^2
  double product, changed;              ///< weighted sums of residual * change, change^2
  double noise, mean, changedMean;
  double changedBy;                                     ///< root mean square of the change
  std::function<double(double factor)> exactGain = {};  ///< where the sums do not tell it

  bool isVisible(double factor) const { return factor * changedBy > enginesDiffer * noise; }

  /// Gain in log density if `factor` times the change is subtracted. While the scale is free, the logarithm
  /// of the mean square counts; once it is at the noise, the mean square itself. The part below the noise
  /// need not count.
  double gain(double factor, bool belowNoise) const {
    if (exactGain) return exactGain(factor);
    const auto of = [&](double square) {
      if (square > least) return std::log(square);
      return std::log(least) + (belowNoise ? square / least - 1 : 0);
    };
    const double now = squares / count,
                 then = std::max(0.0, now - (2 * factor * product - factor * factor * changed) / count);
    const auto ofMean = [&](double of) { return std::log(std::max(noise, std::abs(of))); };
    return share * count / 2 * (of(now) - of(then)) + ofMean(mean) - ofMean(mean - factor * changedMean);
  }
};

}  // namespace

// Removing a mean gains little until it is nearly gone, so the factor is searched over its range, not by
// small steps.
CandidateScreening::Guessed CandidateScreening::guess(const Start& start, const Left& left) const {
  std::vector<Sums> sums;
  for (const Change& change : start.changes)
    for (const std::size_t c : left.at[change.trial][change.signal]) {
      const Left::OfCell& of = left.cells[c];
      if (of.count == 0) continue;
      const float* d = change.values.data() + of.first;
      double mean = 0, p = 0, q = 0, squares = 0;
      for (std::size_t k = 0; k < of.values.size(); ++k)
        if (of.weights[k] > 0) mean += static_cast<double>(d[k]);
      mean /= of.count;
      for (std::size_t k = 0; k < of.values.size(); ++k) {
        if (!(of.weights[k] > 0)) continue;
        const double about = static_cast<double>(d[k]) - mean;
        p += of.weights[k] * of.parts.about[k] * about;
        q += of.weights[k] * about * about;
        squares += about * about;
      }
      sums.push_back({of.share, of.count, std::pow(of.cell.noise / of.scale, 2), of.squares, p, q,
                      of.cell.noise, of.parts.mean, mean, std::sqrt(squares / of.count + mean * mean)});
      if (of.sparse) sums.back().exactGain = [&of, d](double factor) { return of.gain(d, factor); };
    }
  Guessed guessed;
  const auto tryFactor = [&](double factor) {
    if (std::ranges::none_of(sums, [&](const Sums& of) { return of.isVisible(factor); })) return;
    Guessed other{0, 0, factor};
    for (const Sums& of : sums) {
      const double gain = of.gain(factor, true);
      other.gain += gain;
      other.toNoise += of.exactGain ? gain : of.gain(factor, false);
    }
    if (other.gain > guessed.gain) guessed = other;
  };
  constexpr int points = 6;  // to each side
  const double most = start.cause.effect->sticks ? mostOfSticking : mostFactor;
  double step = std::pow(most, 1.0 / points);
  const double leastFactor = start.cause.effect->linear ? leastOfLinear : 1 / most;
  const double factors = std::log(most / leastFactor) / std::log(step) + 0.5;
  double factor = most;
  for (int k = 0; k < factors; ++k, factor /= step) tryFactor(factor);
  for (int halved = 0; halved < 3 && guessed.gain > 0; ++halved) {
    step = std::sqrt(step);
    const double middle = guessed.share;
    tryFactor(middle * step);
    tryFactor(middle / step);
  }
  return guessed;
}

/// The better of a guess and, where feet slip and land or an effect sets in, of the start as it was replayed:
/// a part of it would change something else.
CandidateScreening::Guessed CandidateScreening::rate(const Start& start, const Left& left) const {
  const Guessed guessed = guess(start, left);
  if (!start.cause.effect->setsIn &&
      std::ranges::none_of(start.changes, [&](const Change& change) { return onFeet_[change.trial]; }))
    return guessed;
  const double gain = gainOf(start, left, 1);
  return gain > guessed.gain ? Guessed{gain, gain, 1} : guessed;
}

double CandidateScreening::gainOf(const Start& start, const Left& left, double share) const {
  double gain = 0;
  for (const Change& change : start.changes)
    for (const std::size_t c : left.at[change.trial][change.signal]) {
      const Left::OfCell& of = left.cells[c];
      gain += of.gain(change.values.data() + of.first, share);
    }
  return gain;
}

CandidateScreening::Left CandidateScreening::leftOf(const Groups& groups, const Residuals& residuals,
                                                    const Shares& shares) const {
  Left left;
  for (const Trial& trial : groups.trials()) left.at.emplace_back(trial.signals.size());
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    const Cell& cell = groups.cells()[c];
    const std::size_t n = every_[cell.trial];
    if (!looked_[cell.trial] || !residuals[cell.trial][cell.signal]) continue;
    Left::OfCell of;
    of.cell = cell;
    of.first = (cell.from + n - 1) / n;
    of.share = shares[c] * static_cast<double>(n);
    of.values = thinned(*residuals[cell.trial][cell.signal], cell.from, cell.to, n);
    of.parts = split(of.values);
    const StretchFit fit = fitStretch(of.parts, cell.noise);
    of.scale = fit.scale;
    of.density = fit.density(of.share);
    const MostOfCell most(of.parts, fit, of.share);
    of.sparse = most.isAtNoise && most.gain > priceOf(1, kinds_);
    for (const double r : of.parts.about) {
      const double w = std::isfinite(r) ? weightOf(r, of.scale) : 0;
      of.weights.push_back(w);
      if (w > 0) of.squares += w * r * r, ++of.count;
    }
    if (!(of.squares > 0)) of.squares = 1;
    left.at[cell.trial][cell.signal].push_back(left.cells.size());
    left.cells.push_back(std::move(of));
  }
  return left;
}

/// The best start of each kind that gains, the best kinds first. Starts of a kind follow each other.
std::vector<CandidateScreening::Rated> CandidateScreening::bestOfKinds(
    const Left& left, const std::function<bool(const Start&)>& wanted) const {
  std::vector<Rated> best;
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    if (!wanted(starts_[i])) continue;
    const Rated rated{i, rate(starts_[i], left).gain};
    const bool same = !best.empty() && starts_[best.back().start].cause.sameForm(starts_[i].cause);
    if (!same)
      best.push_back(rated);
    else if (rated.gain > best.back().gain)
      best.back() = rated;
  }
  std::erase_if(best, [](const Rated& of) { return !(of.gain > 0); });
  std::ranges::stable_sort(best, std::ranges::greater(), &Rated::gain);
  if (best.size() > mostClimbed) best.resize(mostClimbed);
  return best;
}

// Larger strengths, then smaller ones, each half or double the one before, while they gain.
void CandidateScreening::replayFurtherStrengths(const Replayer& replayer, const Residuals& nominal,
                                                const Shares& shares) {
  const Left left = leftOf(replayer.groups(), nominal, shares);
  const std::vector<Rated> best =
      bestOfKinds(left, [](const Start& start) { return start.cause.effect->isRough(); });
  std::vector<std::vector<Start>> further(starts_.size());  // by the start that they began at
  for (const auto& [from, gain] : best)
    for (const double way : {std::log(2.0), -std::log(2.0)}) {
      Cause cause = starts_[from].cause;
      for (double before = gain;;) {
        const Cause next =
            withLogStrengths(replayer.mechanism(), {cause}, logStrengths({cause}).array() + way).front();
        if (next == cause) break;
        const std::vector<char>& looked = starts_[from].looked;
        Start start{next, looked,
                    changesOf(replayer.groups(), nominal, replayer.residuals({next}, looked), looked)};
        const double now = rate(start, left).gain;
        if (!(now > before)) break;
        further[from].push_back(std::move(start));
        before = now;
        cause = next;
      }
    }
  std::vector<Start> all;
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    all.push_back(std::move(starts_[i]));
    for (Start& start : further[i]) all.push_back(std::move(start));
  }
  starts_ = std::move(all);
}

// Those that were looked at in some of the trials alone would seem to gain less than others.
void CandidateScreening::replayElsewhere(const Replayer& replayer, const Residuals& nominal,
                                         const Shares& shares) {
  const Left left = leftOf(replayer.groups(), nominal, shares);
  for (const Rated& rated : bestOfKinds(left, [&](const Start& start) { return start.looked != looked_; })) {
    Start& start = starts_[rated.start];
    start.changes =
        changesOf(replayer.groups(), nominal, replayer.residuals({start.cause}, looked_), looked_);
    start.looked = looked_;
  }
}

std::vector<Proposal> CandidateScreening::propose(const Replayer& within, const Explanation& base,
                                                  const Shares& shares, std::size_t most) const {
  const Left left = leftOf(within.groups(), within.residuals(base), shares);
  // The best start of each kind by its guess (starts of a kind follow each other); then the exact gain of the
  // best of these.
  struct KindGuess {
    const Start* start;
    Guessed guessed;
  };
  std::vector<KindGuess> candidates;
  for (const Start& start : starts_) {
    if (std::ranges::any_of(base, [&](const Cause& cause) { return cause.sameKind(start.cause); })) continue;
    const Guessed guessed = rate(start, left);
    if (!(guessed.gain > 0 && guessed.toNoise > 0)) continue;
    const bool same = !candidates.empty() && candidates.back().start->cause.sameForm(start.cause);
    if (!same)
      candidates.push_back({&start, guessed});
    else if (guessed.gain > candidates.back().guessed.gain)
      candidates.back() = {&start, guessed};
  }
  std::ranges::stable_sort(candidates, std::ranges::greater(),
                           [](const KindGuess& candidate) { return candidate.guessed.gain; });
  if (candidates.size() > mostGuessed) candidates.resize(mostGuessed);
  std::vector<Proposal> proposals;
  for (const KindGuess& candidate : candidates) {
    const double gain = gainOf(*candidate.start, left, candidate.guessed.share);
    if (!(gain > 0)) continue;
    const Cause& cause = candidate.start->cause;
    const Eigen::VectorXd x = logStrengths({cause}).array() + std::log(candidate.guessed.share);
    proposals.push_back({withLogStrengths(within.mechanism(), {cause}, x).front(), gain});
  }
  std::ranges::stable_sort(proposals, std::ranges::greater(), &Proposal::gain);
  if (proposals.size() > most) proposals.resize(most);
  return proposals;
}

}  // namespace plumbline::gap
