#include "walking/ModelFit.h"

#include <algorithm>
#include <limits>

#include "optimization/Cmaes.h"
#include "walking/FitSafety.h"

namespace plumbline::walking {
namespace {

using Index = Eigen::Index;

ModelParameters parametersOf(const Eigen::VectorXd& x) {
  std::array<double, ModelParameters::count> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = modelParameterTable[i].neutral + modelParameterTable[i].scale * x[static_cast<Index>(i)];
  return ModelParameters::of(values);
}

SearchSpace spaceFrom(const ModelParameters& start) {
  constexpr auto n = static_cast<Index>(ModelParameters::count);
  SearchSpace space;
  space.start.resize(n);
  space.lower.resize(n);
  space.upper.resize(n);
  space.sigma = Eigen::VectorXd::Constant(n, 0.5);
  for (std::size_t i = 0; i < ModelParameters::count; ++i) {
    const ModelParameterInfo& info = modelParameterTable[i];
    const auto j = static_cast<Index>(i);
    // Steps of one kind of walking tell little of some parameters; none goes far in one fit.
    constexpr double furthest = 2;
    const double from = (start.values()[i] - info.neutral) / info.scale;
    const double low = (info.low - info.neutral) / info.scale, high = (info.high - info.neutral) / info.scale;
    space.start[j] = std::clamp(from, low, high);
    space.lower[j] = std::max(low, space.start[j] - furthest);
    space.upper[j] = std::min(high, space.start[j] + furthest);
  }
  return space;
}

}  // namespace

double predictionError(std::span<const ObservedStep> steps, const ModelParameters& parameters) {
  constexpr double position = 0.005, velocity = 0.05;  // [m, m/s]
  double sum = 0;
  std::size_t count = 0;
  for (const ObservedStep& step : steps) {
    const LinearInvertedPendulum model = step.pendulum.with(parameters);
    // The middle of the step and its end tell as much as all of it.
    for (const std::size_t i : {step.samples.size() / 2, step.samples.size() - 1}) {
      const ObservedStep::Sample& sample = step.samples[i];
      const WalkState end = step.predicted(model, sample.time);
      sum += (end.supportFoot().position - sample.foot).squaredNorm() / (position * position) +
             (end.velocity - sample.velocity).squaredNorm() / (velocity * velocity);
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(4 * count) : 0;
}

ModelFitResult fitModel(std::span<const ObservedStep> steps, const ModelParameters& before,
                        const ModelFitOptions& options) {
  std::vector<ObservedStep> fitted, held;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].samples.empty()) continue;
    (i % 3 == 2 ? held : fitted).push_back(steps[i]);
  }
  ModelFitResult result;
  result.parameters = before;
  result.before = result.after = predictionError(fitted, before);
  result.heldBefore = result.heldAfter = predictionError(held, before);
  if (fitted.empty() || held.empty()) return result;

  CmaesOptions search;
  search.population = options.population;
  search.seed = options.seed;
  search.stop.maxGenerations = options.generations;
  Cmaes optimizer(spaceFrom(before), search);
  // What the steps do not tell stays as it was: a little is paid for every change.
  constexpr double weight = 0.03, weightOfChange = 0.05, weightOfDanger = 10;
  const FitSafety safety(steps);
  while (!optimizer.isDone()) {
    const Eigen::MatrixXd& candidates = optimizer.ask();
    std::vector<double> costs;
    for (Index i = 0; i < candidates.cols(); ++i) {
      const ModelParameters candidate = parametersOf(candidates.col(i));
      const double change = safety.change(candidate);
      costs.push_back(predictionError(fitted, candidate) +
                      weight * candidates.col(i).squaredNorm() / ModelParameters::count +
                      weightOfChange * change * change + weightOfDanger * std::max(0.0, change - 1));
    }
    optimizer.tell(costs);
    result.best.push_back(optimizer.bestCost());
    if (options.goOn && !options.goOn()) return result;
  }
  const ModelParameters found = parametersOf(optimizer.best());
  result.after = predictionError(fitted, found);
  result.heldAfter = predictionError(held, found);
  result.change = safety.change(found);
  result.accepted =
      result.heldAfter < result.heldBefore && result.after < result.before && result.change <= 1;
  if (result.accepted) result.parameters = found;
  return result;
}

}  // namespace plumbline::walking
