#include "gap/diagnosis/ValueFit.h"

#include <algorithm>
#include <cmath>

#include "framework/Parallel.h"
#include "gap/diagnosis/GaussNewton.h"
#include "optimization/Brent.h"
#include "optimization/Cmaes.h"

namespace plumbline::gap {

namespace {

constexpr int evaluations = 32;  // of values fitted together with runs on the feet, which cost much

/// Size of the strength at the bound on the value's side of nominal.
double farthest(const Mechanism& mechanism, const Cause& cause) {
  const Bounds bounds = cause.effect->boundsAt(mechanism, cause.place);
  const Effect& e = *cause.effect;
  return std::max(1e-12, std::abs(e.strengthOf(cause.value < e.nominal ? bounds.lower : bounds.upper)));
}

/// Causes whose values are fitted, in groups that share joints; a free robot's joints all feel each other.
std::vector<std::vector<std::size_t>> coupledGroups(const Evaluator& evaluator, const Explanation& causes) {
  std::vector<std::vector<int>> joints;
  for (const Cause& cause : causes) {
    joints.push_back(evaluator.jointsTouched(cause));
    std::ranges::sort(joints.back());
  }
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < causes.size(); ++i) {
    if (causes[i].effect->decoded) continue;
    std::vector<std::size_t> group = {i};
    std::erase_if(groups, [&](const std::vector<std::size_t>& other) {
      const bool meets = evaluator.hasFloatingBase() || std::ranges::any_of(other, [&](std::size_t j) {
                           return std::ranges::any_of(
                               joints[j], [&](int k) { return std::ranges::binary_search(joints[i], k); });
                         });
      if (meets) group.insert(group.end(), other.begin(), other.end());
      return meets;
    });
    groups.push_back(std::move(group));
  }
  return groups;
}

/// With runs on the feet, whose squares jump where a foot slips or not, by CMA-ES.
Explanation fitByEvolution(const Evaluator& evaluator, const Explanation& causes,
                           const std::vector<std::size_t>& group, int jobs) {
  const Mechanism& mechanism = evaluator.mechanism();
  const auto n = static_cast<Eigen::Index>(group.size());
  // Coordinates: logarithm of each strength against where it is now.
  SearchSpace space;
  space.start = Eigen::VectorXd::Zero(n);
  space.sigma = Eigen::VectorXd::Constant(n, 0.15);
  space.lower = Eigen::VectorXd::Constant(n, -2);
  space.upper = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Cause& cause = causes[group[static_cast<std::size_t>(i)]];
    const double strength = std::max(1e-12, std::abs(cause.effect->strengthOf(cause.value)));
    space.upper[i] = std::clamp(std::log(farthest(mechanism, cause) / strength), 0.01, 2.0);
  }
  const auto at = [&](const Eigen::VectorXd& x) {
    Explanation tried = causes;
    for (Eigen::Index i = 0; i < n; ++i) {
      Cause& cause = tried[group[static_cast<std::size_t>(i)]];
      cause = scaled(mechanism, cause, std::exp(x[i]));
    }
    return tried;
  };
  CmaesOptions options;
  options.seed = 7;
  options.population = 8;
  options.stop.maxEvaluations = evaluations;
  options.stop.tolX = 0.02;
  options.stop.tolFun = 0.5;
  Cmaes optimizer(space, options);
  while (!optimizer.isDone()) {
    const Eigen::MatrixXd& asked = optimizer.ask();
    std::vector<double> costs(static_cast<std::size_t>(asked.cols()));
    parallel(costs.size(), jobs, [&](std::size_t i) {
      costs[i] = evaluator.of(at(asked.col(static_cast<Eigen::Index>(i)))).fitting;
    });
    optimizer.tell(costs);
  }
  return optimizer.bestCost() < evaluator.of(causes).fitting ? at(optimizer.best()) : causes;
}

}  // namespace

Cause scaled(const Mechanism& mechanism, Cause cause, double share) {
  const Bounds bounds = cause.effect->boundsAt(mechanism, cause.place);
  const Effect& e = *cause.effect;
  cause.value = std::clamp(e.valueAt(share * e.strengthOf(cause.value)), bounds.lower, bounds.upper);
  return cause;
}

FittedCause fitValue(const Evaluator& evaluator, const Cause& start, const TrialMask& mask,
                     const ValueSearch& how) {
  const Effect& effect = *start.effect;
  const double most = farthest(evaluator.mechanism(), start), strength = effect.strengthOf(start.value);
  FittedCause best;
  best.fit.fitting = INFINITY;
  const auto evaluate = [&](double logShare) {
    Cause cause = start;
    cause.value =
        effect.valueAt(std::copysign(std::min(most, std::abs(strength) * std::exp(logShare)), strength));
    Fit fit = evaluator.with(cause, mask);
    const double cost = fit.fitting;
    if (cost < best.fit.fitting) best = {cause, std::move(fit), 0};
    return cost;
  };
  const double top = std::log(most / std::abs(strength));
  double lo = -how.step, x = 0, hi = std::min(how.step, top);
  if (hi <= 0) hi = top, x = top - 0.6 * how.step, lo = top - 1.6 * how.step;
  const Bracket b = bracketFrom(evaluate, lo, x, hi, -INFINITY, top, how.bracket);
  minimizeBrent(evaluate, b, how.tolerance, how.within);
  return best;
}

Explanation fitTogether(const Evaluator& evaluator, const Explanation& causes, int jobs) {
  Explanation result = causes;
  // What is decoded moves every joint: what was fitted before meets that.
  const bool meetAll = losesCommands(causes);
  for (const std::vector<std::size_t>& group : coupledGroups(evaluator, causes)) {
    if (group.size() < 2 && !meetAll) continue;
    result = evaluator.hasFloatingBase() ? fitByEvolution(evaluator, result, group, jobs)
                                         : gaussNewton(evaluator, result, group, jobs).causes;
  }
  return result;
}

Explanation fitSettled(const Evaluator& evaluator, Explanation causes, int jobs) {
  for (int pass = 0; pass < 3; ++pass) {
    Explanation again = fitTogether(evaluator, causes, jobs);
    if (again == causes) break;
    causes = std::move(again);
  }
  return causes;
}

}  // namespace plumbline::gap
