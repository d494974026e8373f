#include "gap/diagnosis/CauseSearch.h"

#include <algorithm>
#include <cmath>

#include "framework/Parallel.h"
#include "gap/diagnosis/GapMeter.h"
#include "gap/diagnosis/Onset.h"
#include "gap/diagnosis/UnderLoad.h"

namespace plumbline::gap {

namespace {

constexpr double minPromiseShare =
    0.005;  // of the best promise: with less, an effect is looked at from one start only
// A start that changes this many times more than there is to explain says nothing about smaller values: it is
// scaled down, up to maxRescalings times.
constexpr double overshoots = 4;
constexpr int maxRescalings = 2;
constexpr std::size_t maxSecondLooks = 60;
constexpr std::size_t maxFixedBaseOnly = 12;  // of these, judged on a fixed base that decides little
constexpr std::size_t leastRefined = 4;
constexpr double refineShare = 0.2;   // of the best first look's gain: what promises less is not fitted
constexpr double minKeptShare = 0.5;  // of the gain promised: below, values in between are looked at too
constexpr double polishShare = 0.7;   // of the best fit's gain: what gains less is no rival of the best
constexpr double minGainShare = 0.5;  // of the best fit's gain: with more, a cause does something
constexpr ValueSearch finely = {.step = 0.08, .tolerance = 0.004, .bracket = 6, .within = 4};

/// Squares beyond noise on the blocks for fitting; no cause can be fitted to what only the others show.
double excessForFitting(const Evaluator& evaluator, std::size_t t) {
  const Evidence& data = evaluator.evidence();
  const Trial& trial = data.trials()[t];
  double excess = 0;
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    if (!Evidence::counts(trial.signals[s])) continue;
    double sum = 0, n = 0;
    data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t k, double w, double r) {
      if (!Evidence::forFitting(data.block(t, k))) return;
      sum += w * r * r;
      ++n;
    });
    if (n > 0) excess += std::max(0.0, sum / n - 1);
  }
  return excess;
}

/// The most informative trials about what is unexplained: of each base, those with the largest excess; of
/// repeats, one.
TrialMask tellingTrials(const Evaluator& evaluator, std::size_t count) {
  const auto& trials = evaluator.evidence().trials();
  TrialMask mask(trials.size(), 0);
  for (const bool floatingBase : {false, true}) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t t = 0; t < trials.size(); ++t) {
      if (trials[t].freeBase != floatingBase) continue;
      order.emplace_back(-excessForFitting(evaluator, t), t);
    }
    std::ranges::sort(order);
    std::vector<std::size_t> taken;
    for (const auto& [excess, t] : order) {
      if (taken.size() >= count) break;
      if (std::ranges::none_of(
              taken, [&, t = t](std::size_t other) { return isRepeat(trials[other], trials[t]); })) {
        taken.push_back(t);
        mask[t] = 1;
      }
    }
  }
  return mask;
}

/// Whether only the body as a whole shows a cause: it lies on the way from ground to torso, or in a sensor.
bool bodyOnly(const Evaluator& evaluator, const Cause& cause) {
  const Site site = cause.place.site;
  return site == Site::foot || site == Site::ground || site == Site::imu ||
         (site == Site::link && evaluator.jointsTouched(cause).empty());
}

/// Uses runs with a fixed base if they can show the cause: they cost a hundredth of runs on the feet.
/// floatingBase: uses those too.
TrialMask showing(const Evaluator& evaluator, const Cause& cause, TrialMask mask, bool floatingBase) {
  const auto& trials = evaluator.evidence().trials();
  const bool body = bodyOnly(evaluator, cause),
             fixedOnly = !body && !floatingBase && evaluator.hasFixedBase();
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].freeBase && fixedOnly) mask[t] = 0;
    if (!trials[t].freeBase && body && cause.place.site != Site::imu) mask[t] = 0;
  }
  return mask;
}

bool oneStart(const Cause& a, const Cause& b) { return a.sameKind(b) && a.variant == b.variant; }

/// A candidate with the value that its first look was at.
struct Lead : FittedCause {
  Cause start;
};

class Searcher {
public:
  Searcher(const Evaluator& fine, const Evaluator& coarse, const SearchOptions& options)
      : fine_(fine),
        coarse_(coarse),
        options_(options),
        most_(tellingTrials(fine, 1)),
        telling_(tellingTrials(fine, 2)),
        fixedBaseTells_(fixedBaseDecides(fine)),
        underLoad_(fine) {}

  std::vector<FittedCause> run(const std::vector<Cause>& causes) {
    firstLook(withOnsets(causes));
    bestStarts();
    secondLook();
    fitRoughly();
    polish();
    const double before = fine_.baseFit().fitting;
    double most = 0;
    for (const FittedCause& c : chosen_) most = std::max(most, before - c.fit.fitting);
    std::erase_if(chosen_, [&](const FittedCause& c) {
      const double gain = before - c.fit.fitting;
      // A limit on a DC motor, which has none, changes the motion by its presence, however small it is.
      return gain <= 0 || (doesNothing(fine_.mechanism(), c.cause) && gain < minGainShare * most);
    });
    std::stable_sort(chosen_.begin(), chosen_.end(), [](const FittedCause& a, const FittedCause& b) {
      return a.fit.judging < b.fit.judging;
    });
    // Keeps the better variant of each kind.
    std::vector<FittedCause> result;
    for (Lead& candidate : chosen_)
      if (std::ranges::none_of(result,
                               [&](const FittedCause& c) { return c.cause.sameKind(candidate.cause); }))
        result.push_back(std::move(candidate));
    return result;
  }

private:
  /// Whether a cause that runs with a fixed base could show is judged on those with a floating base too.
  bool onFeet(const Cause& cause) const { return !fixedBaseTells_ || onlyUnderLoad(cause); }
  bool onlyUnderLoad(const Cause& cause) const { return underLoad_.shows(*cause.effect, cause.place); }
  /// Trials to fit on: the most informative ones with a fixed base, and the first of those with a floating
  /// base.
  TrialMask tellingOf(const Cause& cause) const {
    TrialMask mask = showing(fine_, cause, telling_, onFeet(cause));
    for (std::size_t t = 0; t < mask.size(); ++t)
      if (fine_.evidence().trials()[t].freeBase) mask[t] = mask[t] && most_[t];
    return mask;
  }
  TrialMask everyOf(const Cause& cause) const { return showing(fine_, cause, every_, onFeet(cause)); }

  /// Adds the values that follow from moments of onset, after the other starts of their kinds.
  std::vector<Cause> withOnsets(const std::vector<Cause>& causes) const {
    std::vector<std::optional<Cause>> byOnset(causes.size());
    parallel(causes.size(), options_.jobs, [&](std::size_t i) {
      const bool last = i + 1 == causes.size() || !oneStart(causes[i], causes[i + 1]);
      if (causes[i].effect->setsIn && last) byOnset[i] = causeByOnset(fine_, causes[i]);
    });
    std::vector<Cause> result;
    for (std::size_t i = 0; i < causes.size(); ++i) {
      result.push_back(causes[i]);
      if (byOnset[i]) result.push_back(*byOnset[i]);
    }
    return result;
  }

  /// One replay of the most informative run for each effect and place, scaled to fit best (more if the start
  /// is far too strong for this joint). Other starting values follow if the result is promising or says
  /// little about them.
  void firstLook(const std::vector<Cause>& causes) {
    looked_.resize(causes.size());
    std::vector<double> promise(causes.size(), 0);
    std::vector<std::size_t> first, other;
    for (std::size_t i = 0; i < causes.size(); ++i)
      (i == 0 || !oneStart(causes[i], causes[i - 1]) ? first : other).push_back(i);
    const double whole = coarse_.baseFit().fitting;
    const auto look = [&](const std::vector<std::size_t>& which, double from, double to) {
      stage(from, to, which.size());
      parallel(which.size(), options_.jobs, [&](std::size_t n) {
        const std::size_t i = which[n];
        Lead& candidate = looked_[i];
        candidate.cause = candidate.start = causes[i];
        const TrialMask mask = showing(fine_, causes[i], most_, onlyUnderLoad(causes[i]));
        Fit fit = coarse_.with(causes[i], mask);
        for (int again = 0; again < maxRescalings && fit.change > overshoots * whole; ++again) {
          candidate.cause = candidate.start =
              scaled(fine_.mechanism(), candidate.cause, std::sqrt(whole / fit.change));
          fit = coarse_.with(candidate.cause, mask);
        }
        promise[i] = fit.change > 0 ? fit.product * fit.product / fit.change : 0;
        const double share = std::clamp(fit.bestShare(), 0.0, 5.0);
        candidate.screened = 2 * share * fit.product - share * share * fit.change;
        const double gain = coarse_.baseFit().fitting - fit.fitting;
        if (gain > candidate.screened)
          candidate.screened = gain;
        else if (share > 0.02)
          candidate.cause = scaled(fine_.mechanism(), candidate.cause, share);
        report();
      });
    };
    look(first, 0, 0.3);
    const double best = promise.empty() ? 0 : *std::ranges::max_element(promise);
    double promised = 0;
    std::size_t at = 0;
    std::vector<std::size_t> hopeful;
    for (std::size_t i = 0; i < causes.size(); ++i) {
      if (at < first.size() && first[at] == i)
        promised = promise[i], ++at;
      else if (!causes[i].effect->linear || promised > minPromiseShare * best)
        hopeful.push_back(i);
    }
    look(hopeful, 0.3, 0.5);
  }

  /// The best start of each kind, variant and direction. Runs with a fixed base that show little of the gap
  /// do not compare with the rest yet: the best candidates from them are kept too.
  void bestStarts() {
    std::stable_sort(looked_.begin(), looked_.end(),
                     [](const FittedCause& a, const FittedCause& b) { return a.screened > b.screened; });
    std::size_t onlyFixedBase = 0;
    for (const Lead& candidate : looked_) {
      if (chosen_.size() >= maxSecondLooks || candidate.screened <= 0) break;
      const bool onFixedBase = !fixedBaseTells_ && !bodyOnly(fine_, candidate.cause);
      if (onFixedBase && onlyFixedBase >= maxFixedBaseOnly) continue;
      const auto below = [](const Cause& cause) { return cause.value < cause.effect->nominal; };
      const bool known = std::ranges::any_of(chosen_, [&](const FittedCause& c) {
        return oneStart(c.cause, candidate.cause) && below(c.cause) == below(candidate.cause);
      });
      if (known) continue;
      chosen_.push_back(candidate);
      onlyFixedBase += onFixedBase;
    }
  }

  /// The scaled change can be wrong where an effect is far from linear: a limit that is hardly ever reached
  /// is somewhere between. Keeps the candidates that are worth a fit.
  void secondLook() {
    parallel(chosen_.size(), options_.jobs, [&](std::size_t i) {
      Lead& lead = chosen_[i];
      const TrialMask mask = tellingOf(lead.cause);
      const double base = coarse_.baseFit().fitting, promised = lead.screened;
      const Fit fit = coarse_.with(lead.cause, mask);
      lead.screened = base - fit.fitting;
      const auto look = [&](const Cause& cause) {
        const double gain = base - coarse_.with(cause, mask).fitting;
        if (gain > lead.screened) lead.screened = gain, lead.cause = cause;
      };
      const double share = std::clamp(fit.bestShare(), 0.3, 3.0);
      const Cause first = lead.cause;
      if (std::abs(share - 1) > 0.05) look(scaled(fine_.mechanism(), first, share));
      const double way = first.effect->strengthOf(first.value) / first.effect->strengthOf(lead.start.value);
      if (first.effect->linear || lead.screened >= minKeptShare * promised || !(way > 0)) return;
      for (const double part : {0.25, 0.5, 0.75})
        look(scaled(fine_.mechanism(), lead.start, std::pow(way, part)));
    });
    std::stable_sort(chosen_.begin(), chosen_.end(),
                     [](const FittedCause& a, const FittedCause& b) { return a.screened > b.screened; });
    std::erase_if(chosen_, [&](const Lead& lead) { return lead.screened < options_.leastGain; });
    while (!chosen_.empty() && (chosen_.size() > options_.refine ||
                                chosen_.back().screened <= refineShare * chosen_.front().screened ||
                                chosen_.back().screened <= 0)) {
      if (chosen_.back().screened > 0 && chosen_.size() <= leastRefined) break;
      chosen_.pop_back();
    }
  }

  /// Fits values with long steps on the most informative trials, then evaluates each result finely on all.
  void fitRoughly() {
    stage(0.5, 0.8, chosen_.size());
    parallel(chosen_.size(), options_.jobs, [&](std::size_t i) {
      Lead& candidate = chosen_[i];
      const TrialMask mask = tellingOf(candidate.cause), all = everyOf(candidate.cause);
      const Cause first = candidate.cause;
      const FittedCause fitted = fitValue(coarse_, first, mask, roughly);
      candidate.cause = fitted.cause;
      candidate.fit = fine_.with(candidate.cause, all);
      // Where the gain ends abruptly beyond the best value, coarse steps place that end elsewhere.
      if (fine_.baseFit().fitting - candidate.fit.fitting <
          minKeptShare * (coarse_.baseFit().fitting - fitted.fit.fitting)) {
        const FittedCause again = fitValue(fine_, first, mask, roughly);
        Fit fit = fine_.with(again.cause, all);
        if (fit.fitting < candidate.fit.fitting)
          candidate.cause = again.cause, candidate.fit = std::move(fit);
      }
      report();
    });
  }

  /// Fine steps for those that may turn out the best. Runs on a floating base cost much: the value is
  /// fitted on those that show most, then judged on all.
  void polish() {
    std::stable_sort(chosen_.begin(), chosen_.end(), [](const FittedCause& a, const FittedCause& b) {
      return a.fit.fitting < b.fit.fitting;
    });
    const double base = fine_.baseFit().fitting;
    std::size_t rivals = 0;
    while (rivals < chosen_.size() &&
           base - chosen_[rivals].fit.fitting >= polishShare * (base - chosen_.front().fit.fitting))
      ++rivals;
    stage(0.8, 1, rivals);
    parallel(rivals, options_.jobs, [&](std::size_t i) {
      Lead& candidate = chosen_[i];
      const TrialMask all = everyOf(candidate.cause);
      TrialMask fitted = all;
      for (std::size_t t = 0; t < fitted.size(); ++t)
        if (fine_.evidence().trials()[t].freeBase) fitted[t] = all[t] && telling_[t];
      FittedCause better = fitValue(fine_, candidate.cause, fitted, finely);
      if (fitted != all) better.fit = fine_.with(better.cause, all);
      better.screened = candidate.screened;
      if (better.fit.fitting < candidate.fit.fitting)
        static_cast<FittedCause&>(candidate) = std::move(better);
      report();
    });
  }

  void stage(double from, double to, std::size_t count) {
    done_ = 0;
    stageFrom_ = from;
    stageShare_ = (to - from) / static_cast<double>(std::max<std::size_t>(count, 1));
  }
  void report() {
    const std::size_t n = ++done_;
    if (options_.progress) options_.progress(stageFrom_ + stageShare_ * static_cast<double>(n));
  }

  const Evaluator &fine_, &coarse_;
  const SearchOptions& options_;
  const TrialMask most_, telling_, every_ = TrialMask(telling_.size(), 1);
  const bool fixedBaseTells_;
  const UnderLoad underLoad_;
  std::vector<Lead> looked_, chosen_;
  std::atomic<std::size_t> done_ = 0;
  double stageFrom_ = 0, stageShare_ = 0;
};

}  // namespace

std::vector<FittedCause> search(const Evaluator& evaluator, const Evaluator& coarse,
                                const std::vector<Cause>& causes, const SearchOptions& options) {
  return Searcher(evaluator, coarse, options).run(causes);
}

}  // namespace plumbline::gap
