#include "gap/diagnosis/ConfigurationChange.h"

#include <algorithm>
#include <map>
#include <string>

#include "framework/Parallel.h"
#include "gap/diagnosis/AcceptanceTest.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

namespace {

constexpr double leastShareOfOne = 0.2;   // of a recording's squares that has to go without the cause
constexpr double leastShareOfAll = 0.05;  // of all squares, for each recording, with values fitted again
constexpr std::size_t fittedStarts = 6;
constexpr double mostShareOfNeedless = 0.02;  // more squares without a cause that is not needed

/// Squares on the blocks for judging of each recording with a fixed base.
std::map<std::string, double> squaresByRecording(const Evidence& data, const Fit& fit) {
  std::map<std::string, double> sums;
  for (std::size_t t = 0; t < data.trials().size(); ++t) {
    const Trial& trial = data.trials()[t];
    if (trial.freeBase || trial.cycles() == 0) continue;
    double& sum = sums[trial.recording];
    for (std::size_t b = data.block(t, 0); b <= data.block(t, trial.cycles() - 1); ++b)
      if (!Evidence::forFitting(b)) sum += fit.squares[b];
  }
  return sums;
}

/// Adds or removes the recording that gains most by the change, if it gains clearly. Returns the list as it
/// is if no recording does, or only the last one that shows the cause.
std::vector<std::string> changed(const Evaluator& evaluator, const Explanation& causes, std::size_t i) {
  const Evidence& data = evaluator.evidence();
  Explanation everywhere = causes;
  everywhere[i].inactiveIn.clear();
  const auto with = squaresByRecording(data, evaluator.of(everywhere)),
             less = squaresByRecording(data, evaluator.of(without(causes, i)));
  std::vector<std::string> names = causes[i].inactiveIn;
  std::string most;
  double mostGain = leastGain;
  bool shown = false;
  for (const auto& [name, squares] : with) {
    const bool out = std::ranges::find(names, name) != names.end();
    const double now = out ? less.at(name) : squares, then = out ? squares : less.at(name);
    shown = shown || less.at(name) - squares > std::max(leastGain, leastShareOfOne * less.at(name));
    if (now - then < std::max(mostGain, leastShareOfOne * now)) continue;
    mostGain = now - then;
    most = name;
  }
  if (most.empty() || !shown) return names;
  if (std::erase(names, most) == 0) names.push_back(most);
  std::ranges::sort(names);
  return names;
}

/// The cause, inactive in recordings that it makes far worse; active in all if it makes none far better.
FittedCause setInSome(const Evaluator& nominal, Cause cause) {
  const Evidence& data = nominal.evidence();
  cause.inactiveIn.clear();
  Fit fit = nominal.with(cause);
  const auto before = squaresByRecording(data, nominal.baseFit()), after = squaresByRecording(data, fit);
  bool any = false;
  for (const auto& [name, squares] : before) {
    const double loss = after.at(name) - squares, far = std::max(leastGain, leastShareOfOne * squares);
    any = any || -loss > far;
    if (loss <= far) continue;
    cause.inactiveIn.push_back(name);
    fit.judging -= loss;
  }
  if (!any) cause.inactiveIn.clear();
  return {cause, std::move(fit), 0};
}

/// Without the causes that only made up for recordings that are now treated separately.
Explanation needed(const Evaluator& evaluator, Explanation causes, int jobs) {
  double judging = evaluator.of(causes).judging;
  for (std::size_t i = causes.size(); i-- > 0;) {
    if (!causes[i].inactiveIn.empty()) continue;
    Explanation less = fitSettled(evaluator, without(causes, i), jobs);
    const double left = evaluator.of(less).judging;
    if (left - judging >= std::max(leastGain, mostShareOfNeedless * judging)) continue;
    causes = std::move(less);
    judging = left;
  }
  return causes;
}

}  // namespace

Explanation inactiveWhereNotSet(const Evaluator& evaluator, int jobs) {
  const Explanation& base = evaluator.base();
  Explanation best = base;
  for (std::size_t i = 0; i < best.size(); ++i) {
    while (best[i].effect->setting) {
      Explanation tried = best;
      tried[i].inactiveIn = changed(evaluator, best, i);
      if (tried[i].inactiveIn == best[i].inactiveIn) break;
      tried = fitTogether(evaluator, tried, jobs);
      // The changes end: each takes away its share.
      if (evaluator.of(tried).judging > (1 - leastShareOfAll) * evaluator.of(best).judging) break;
      best = std::move(tried);
    }
  }
  return best == base ? base : needed(evaluator, fitSettled(evaluator, best, jobs), jobs);
}

Explanation configurationOfSome(const Evaluator& nominal, int jobs) {
  std::vector<Cause> starts = possibleCauses(nominal);
  std::erase_if(starts, [](const Cause& cause) { return !cause.effect->setting; });
  std::vector<FittedCause> tried(starts.size());
  parallel(starts.size(), jobs, [&](std::size_t i) { tried[i] = setInSome(nominal, starts[i]); });
  std::erase_if(tried, [](const FittedCause& candidate) { return candidate.cause.inactiveIn.empty(); });
  const auto better = [](const FittedCause& a, const FittedCause& b) {
    return a.fit.judging < b.fit.judging;
  };
  std::ranges::stable_sort(tried, better);
  tried.resize(std::min(tried.size(), fittedStarts));
  parallel(tried.size(), jobs, [&](std::size_t i) {
    tried[i] = fitValue(nominal, tried[i].cause, {});
    tried[i] = setInSome(nominal, tried[i].cause);
  });
  std::erase_if(tried, [](const FittedCause& candidate) { return candidate.cause.inactiveIn.empty(); });
  if (tried.empty()) return {};
  return {std::ranges::min_element(tried, better)->cause};
}

}  // namespace plumbline::gap
