#include "gap/diagnosis/GroupedCrossValidation.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>

#include "framework/Parallel.h"
#include "gap/diagnosis/AcceptanceTest.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/ValueFit.h"
#include "gap/replay/Ensemble.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t width = 3;        // sets that go on
constexpr std::size_t fittedAgain = 6;  // of the longer sets: a fit that stuck may go on
constexpr int fitPasses = 3;            // of fits, of a set that was chosen
// A further cause must remove these shares of the error and of the nominal model's error.
constexpr double leastShare = 0.05, leastOfAll = 0.02;

/// What distinguishes one servo setting from another.
std::vector<double> gainsOf(const Trial& trial) {
  std::vector<double> gains;
  for (const auto& joint : trial.robot->joints)
    for (const double gain : {joint.servo.kp, joint.servo.kd, joint.servo.kpFirmware}) gains.push_back(gain);
  return gains;
}

/// Whether the prediction of causes is uncertain, which would excuse all that they do not explain.
bool inDoubt(const Mechanism& mechanism, const Explanation& causes) {
  return anyLimitCycle(plantOf(mechanism, causes));
}

bool better(const GroupedCrossValidation::Tried& a, const GroupedCrossValidation::Tried& b) {
  return a.error < b.error;
}

}  // namespace

GroupedCrossValidation::Fold::Fold(const Mechanism& mechanism, std::vector<Trial> fittedTrials,
                                   std::vector<Trial> leftTrials, const ReplayOptions& accuracy)
    : fitted(std::move(fittedTrials)),
      left(std::move(leftTrials)),
      fit(mechanism, fitted, accuracy),
      judge(mechanism, left, accuracy) {}

GroupedCrossValidation::GroupedCrossValidation(const Mechanism& mechanism, const Evidence& evidence, int jobs,
                                               const ReplayOptions& accuracy, Left leftOut)
    : robot_(mechanism), jobs_(jobs) {
  using Group = std::pair<std::string, std::vector<double>>;
  const auto groupOf = [leftOut](const Trial& trial) {
    return leftOut == Left::motion ? Group(trial.recordedMotion, {}) : Group("", gainsOf(trial));
  };
  std::vector<Group> groups;
  std::vector<Trial> trials;
  for (const Trial& trial : evidence.trials()) {
    if (trial.freeBase) continue;
    trials.push_back(trial);
    if (std::ranges::find(groups, groupOf(trial)) == groups.end()) groups.push_back(groupOf(trial));
  }
  if (groups.size() < 2) return;
  for (const Group& out : groups) {
    std::vector<Trial> fitted, left;
    for (const Trial& trial : trials) (groupOf(trial) == out ? left : fitted).push_back(trial);
    folds_.push_back(std::make_unique<Fold>(mechanism, std::move(fitted), std::move(left), accuracy));
    folds_.back()->nominal = squaresLeft(*folds_.back(), {});
  }
}

double GroupedCrossValidation::squaresLeft(const Fold& fold, const Explanation& causes) const {
  const Fit fit = fold.judge.of(causes);
  return std::max(0.0, fit.fitting + fit.judging);
}

GroupedCrossValidation::Tried GroupedCrossValidation::fitted(const Tried& from) const {
  Tried result = from;
  result.error = 0;
  for (std::size_t f = 0; f < folds_.size(); ++f) {
    Explanation& causes = result.perFold[f];
    causes = causes.size() > 1 ? fitTogether(folds_[f]->fit, causes, 1)
                               : Explanation{fitValue(folds_[f]->fit, causes.front(), {}).cause};
    if (inDoubt(robot_, causes)) result.error = INFINITY;
    result.error +=
        std::sqrt(squaresLeft(*folds_[f], causes) / folds_[f]->nominal) / static_cast<double>(folds_.size());
  }
  result.causes = result.perFold.front();
  for (std::size_t i = 0; i < result.causes.size(); ++i) {
    const Effect& effect = *result.causes[i].effect;
    double strength = 0;
    for (const Explanation& fold : result.perFold)
      strength += effect.strengthOf(fold[i].value) / static_cast<double>(folds_.size());
    result.causes[i].value = effect.valueAt(strength);
  }
  return result;
}

GroupedCrossValidation::Tried GroupedCrossValidation::refined(Tried tried) const {
  for (int pass = 0; pass < fitPasses; ++pass) {
    Tried again = fitted(tried);
    if (again.error >= tried.error && pass > 0) break;
    tried = std::move(again);
  }
  return tried;
}

GroupedCrossValidation::Tried GroupedCrossValidation::of(const Explanation& causes) const {
  Tried tried;
  if (causes.empty()) return tried;
  tried.perFold.assign(folds_.size(), causes);
  return refined(tried);
}

GroupedCrossValidation::Tried GroupedCrossValidation::withBestVariants(Tried best) const {
  for (std::size_t i = 0; i < best.causes.size(); ++i) {
    std::vector<Tried> tried(static_cast<std::size_t>(best.causes[i].effect->numVariants()), best);
    if (tried.size() < 2) continue;
    parallel(tried.size(), jobs_, [&](std::size_t v) {
      const auto variant = static_cast<int>(v);
      if (std::ranges::all_of(best.perFold,
                              [&](const Explanation& fold) { return fold[i].variant == variant; }))
        return;
      for (Explanation& fold : tried[v].perFold) fold[i].variant = variant;
      tried[v] = refined(std::move(tried[v]));
    });
    Tried& least = *std::ranges::min_element(tried, better);
    if (least.error < (1 - leastShare) * best.error) best = std::move(least);
  }
  return best;
}

GroupedCrossValidation::Tried GroupedCrossValidation::withKind(const Tried& from,
                                                               const std::vector<Cause>& starts) const {
  Tried tried = from;
  tried.perFold.resize(folds_.size());
  for (std::size_t f = 0; f < folds_.size(); ++f) {
    double least = INFINITY;
    Explanation best;
    for (const Cause& start : starts) {
      Explanation causes = tried.perFold[f];
      causes.push_back(start);
      const double fitting = folds_[f]->fit.of(causes).fitting;
      if (fitting >= least) continue;
      least = fitting;
      best = std::move(causes);
    }
    tried.perFold[f] = std::move(best);
  }
  // No start was successful.
  if (std::ranges::any_of(tried.perFold, &Explanation::empty)) {
    tried.error = INFINITY;
    return tried;
  }
  return fitted(tried);
}

GroupedCrossValidation::Tried GroupedCrossValidation::best(
    const std::vector<Cause>& starts, std::size_t maxCauses,
    const std::function<void(double share)>& progress) const {
  const std::vector<std::vector<Cause>> kinds = byKind(robot_, starts);
  std::vector<Tried> sets(1);
  Tried best;
  for (std::size_t size = 1; size <= maxCauses; ++size) {
    std::vector<std::pair<const Tried*, const std::vector<Cause>*>> pairs;
    for (const Tried& set : sets)
      for (const std::vector<Cause>& kind : kinds)
        if (std::ranges::none_of(set.causes, [&](const Cause& c) { return c.sameKind(kind.front()); }))
          pairs.emplace_back(&set, &kind);
    std::vector<Tried> longer(pairs.size());
    std::atomic<std::size_t> done = 0;
    parallel(pairs.size(), jobs_, [&](std::size_t i) {
      longer[i] = withKind(*pairs[i].first, *pairs[i].second);
      progress(
          (static_cast<double>(size - 1) + static_cast<double>(++done) / static_cast<double>(pairs.size())) /
          static_cast<double>(maxCauses));
    });
    std::ranges::stable_sort(longer, better);
    longer.resize(std::min(longer.size(), fittedAgain));
    if (size > 1) parallel(longer.size(), jobs_, [&](std::size_t i) { longer[i] = fitted(longer[i]); });
    std::ranges::stable_sort(longer, better);
    if (longer.empty() || best.error - longer.front().error < std::max(leastShare * best.error, leastOfAll))
      break;
    longer.resize(std::min(longer.size(), width));
    best = longer.front();
    sets = std::move(longer);
  }
  return best.causes.empty() ? best : refined(best);
}

Explanation betterAcrossMotions(const Evaluator& evaluator, const Explanation& proposed,
                                const Explanation& old, int jobs) {
  const GroupedCrossValidation motions(evaluator.mechanism(), evaluator.evidence(), jobs, coarseSteps(),
                                       GroupedCrossValidation::Left::motion);
  std::array<GroupedCrossValidation::Tried, 2> tried;
  if (motions.possible()) {
    parallel(2, jobs, [&](std::size_t i) { tried[i] = motions.of(i ? old : proposed); });
    tried[0] = motions.withBestVariants(std::move(tried[0]));
  }
  if (!motions.possible() || !std::isfinite(tried[0].error) || !std::isfinite(tried[1].error))
    return evaluator.of(proposed).judging < evaluator.of(old).judging - leastGain ? proposed : old;
  if (tried[0].error >= tried[1].error) return old;
  return fitSettled(evaluator, std::move(tried[0].causes), jobs);
}

}  // namespace plumbline::gap
