#include "gap/diagnosis/SharedCauses.h"

#include <algorithm>
#include <atomic>

#include "framework/Parallel.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/GroupedCrossValidation.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t pairedFrom = 5;  // the kinds that fit best alone: all their pairs are tried
constexpr std::size_t extendedBy = 3;  // the kinds that fit best on top of a set: each is tried in it
// Share of the nominal model's squares that a further cause must explain; from the third on also of the
// remaining squares.
constexpr double leastOfAll = 0.02, leastOfRest = 0.2;
constexpr double nearlyAsGood = 2;  // times what is left: another form of a law that is extended too

/// Starting values of each kind and variant that acts at all joints.
std::vector<std::vector<Cause>> kindsPossible(const Evaluator& nominal) {
  std::vector<Cause> starts = possibleCauses(nominal);
  std::erase_if(starts, [](const Cause& cause) { return cause.place.site != Site::everywhere; });
  return byKind(nominal.mechanism(), starts);
}

/// From the start that fits best.
FittedCause fittedAlone(const Evaluator& evaluator, const std::vector<Cause>& starts) {
  FittedCause best;
  best.fit.fitting = INFINITY;
  for (const Cause& start : starts)
    if (Fit fit = evaluator.with(start); fit.fitting < best.fit.fitting) best = {start, std::move(fit), 0};
  return best.cause.effect ? fitValue(evaluator, best.cause, {}, roughly) : best;
}

/// The same runs; each channel weighs as much as any other, but where there is hardly more than noise.
Evidence evenly(const Evaluator& nominal) {
  return nominal.evidence().weightedBy([&](std::size_t trial, std::size_t signal) {
    const double chi = nominal.chi(trial, signal);
    return std::isfinite(chi) ? 1 / std::max(1.0, chi) : 1;
  });
}

class Chooser {
public:
  Chooser(const Evaluator& nominal, int jobs, const std::function<void(double)>& progress)
      : kinds_(kindsPossible(nominal)),
        evidence_(evenly(nominal)),
        fine_(nominal.mechanism(), evidence_),
        coarse_(nominal.mechanism(), evidence_, coarseSteps()),
        jobs_(jobs),
        progress_(progress) {
    fine_.setBase({});
    coarse_.setBase({});
  }

  Explanation run(std::size_t maxCauses) {
    if (maxCauses < 2) return {};
    rounds_ = static_cast<double>(2 * maxCauses - 2);
    const std::vector<FittedCause> alone = ranked({});
    if (alone.size() < 2) return {};

    std::vector<Explanation> pairs;
    for (std::size_t i = 0; i < std::min(pairedFrom, alone.size()); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!alone[i].cause.sameKind(alone[j].cause)) pairs.push_back({alone[j].cause, alone[i].cause});
    Set best = bestOf(std::move(pairs));
    const double least = leastOfAll * fine_.baseFit().judging;
    if (fine_.of({alone.front().cause}).judging - best.left < least) return {};
    while (best.causes.size() < maxCauses) {
      std::vector<Explanation> larger;
      const std::vector<Explanation> sets = inItsVariants(best);
      parts_ = sets.size();
      for (const Explanation& set : sets) {
        const std::vector<FittedCause> further = ranked(set);
        for (std::size_t i = 0; i < std::min(extendedBy, further.size()); ++i) {
          larger.push_back(set);
          larger.back().push_back(further[i].cause);
        }
      }
      parts_ = 1;
      Set next = bestOf(std::move(larger));
      if (best.left - next.left < std::max(least, leastOfRest * best.left)) break;
      best = std::move(next);
    }
    return best.causes;
  }

private:
  struct Set {
    Explanation causes;
    double left = INFINITY;  ///< squares on the blocks for judging
  };

  /// The set, and variants of it with one cause in another form of its law, values fitted again. While a
  /// cause is missing, the form that fits best absorbs it, so that it would not be found.
  std::vector<Explanation> inItsVariants(const Set& set) {
    std::vector<Explanation> others;
    for (std::size_t i = 0; i < set.causes.size(); ++i)
      for (int v = 0; v < set.causes[i].effect->numVariants(); ++v) {
        if (v == set.causes[i].variant) continue;
        others.push_back(set.causes);
        others.back()[i].variant = v;
      }
    std::vector<double> left(others.size());
    parallel(others.size(), jobs_, [&](std::size_t i) {
      others[i] = fitTogether(coarse_, others[i], 1);
      left[i] = fine_.of(others[i]).judging;
    });
    std::vector<Explanation> sets = {set.causes};
    for (std::size_t i = 0; i < others.size(); ++i)
      if (left[i] < nearlyAsGood * set.left) sets.push_back(std::move(others[i]));
    return sets;
  }

  /// Every kind that the causes do not have, fitted on top of them; the one that fits best first.
  std::vector<FittedCause> ranked(const Explanation& causes) {
    coarse_.setBase(causes);
    std::vector<FittedCause> list(kinds_.size());
    each(kinds_.size(), [&](std::size_t i) {
      const auto there = [&](const Cause& cause) { return cause.sameKind(kinds_[i].front()); };
      if (std::ranges::none_of(causes, there)) list[i] = fittedAlone(coarse_, kinds_[i]);
    });
    std::erase_if(list, [](const FittedCause& candidate) { return !candidate.cause.effect; });
    std::ranges::stable_sort(
        list, [](const FittedCause& a, const FittedCause& b) { return a.fit.fitting < b.fit.fitting; });
    return list;
  }

  /// Each with its values fitted together; the one that predicts best.
  Set bestOf(std::vector<Explanation> sets) {
    std::vector<double> left(sets.size());
    each(sets.size(), [&](std::size_t i) {
      sets[i] = fitTogether(coarse_, sets[i], 1);
      left[i] = fine_.of(sets[i]).judging;
    });
    if (sets.empty()) return {};
    const auto best = static_cast<std::size_t>(std::ranges::min_element(left) - left.begin());
    return {std::move(sets[best]), left[best]};
  }

  void each(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> done = 0;
    parallel(count, jobs_, [&](std::size_t i) {
      work(i);
      const double share = static_cast<double>(++done) / static_cast<double>(count);
      const double part = static_cast<double>(partsDone_) + share;
      if (progress_) progress_((round_ + part / static_cast<double>(parts_)) / rounds_);
    });
    if (++partsDone_ < parts_) return;
    partsDone_ = 0;
    ++round_;
  }

  const std::vector<std::vector<Cause>> kinds_;
  const Evidence evidence_;
  Evaluator fine_, coarse_;
  const int jobs_;
  const std::function<void(double)>& progress_;
  double round_ = 0, rounds_ = 1;
  std::size_t parts_ = 1, partsDone_ = 0;  // of the round
};

}  // namespace

Explanation sharedCauses(const Evaluator& nominal, std::size_t maxCauses, int jobs,
                         const std::function<void(double share)>& progress) {
  return Chooser(nominal, jobs, progress).run(maxCauses);
}

}  // namespace plumbline::gap
