#include "walking/estimation/ModelFit.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "optimization/Optimizers.h"
#include "walking/estimation/FitSafety.h"

namespace plumbline::walking {
namespace {

using Index = Eigen::Index;

ModelParameters parametersOf(const Eigen::VectorXd& x) {
  std::array<double, ModelParameters::count> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = modelParameterTable[i].neutral + modelParameterTable[i].scale * x[static_cast<Index>(i)];
  return ModelParameters::of(values);
}

/// furthest: from where it starts, in typical deviations.
SearchSpace spaceFrom(const ModelParameters& start, double furthest) {
  constexpr auto n = static_cast<Index>(ModelParameters::count);
  SearchSpace space;
  space.start.resize(n);
  space.lower.resize(n);
  space.upper.resize(n);
  space.sigma = Eigen::VectorXd::Constant(n, 0.5);
  for (std::size_t i = 0; i < ModelParameters::count; ++i) {
    const ModelParameterInfo& info = modelParameterTable[i];
    const auto j = static_cast<Index>(i);
    const double from = (start.values()[i] - info.neutral) / info.scale;
    const double low = (info.low - info.neutral) / info.scale, high = (info.high - info.neutral) / info.scale;
    space.start[j] = std::clamp(from, low, high);
    space.lower[j] = std::max(low, space.start[j] - furthest);
    space.upper[j] = std::min(high, space.start[j] + furthest);
  }
  return space;
}

/// The parameters of least cost; nothing if the options end the search.
template <class Cost>
std::optional<ModelParameters> search(const SearchSpace& space, const ModelFitOptions& options,
                                      std::vector<double>& best, const Cost& cost) {
  OptimizerOptions given;
  given.population = options.population;
  given.seed = options.seed;
  given.stop.maxGenerations = options.generations;
  const std::unique_ptr<Optimizer> chosen = makeOptimizer(options.optimizer, space, given);
  Optimizer& optimizer = *chosen;
  while (!optimizer.isDone()) {
    const Eigen::MatrixXd& candidates = optimizer.ask();
    std::vector<double> costs;
    for (Index i = 0; i < candidates.cols(); ++i) costs.push_back(cost(candidates.col(i)));
    optimizer.tell(costs);
    best.push_back(optimizer.bestCost());
    if (options.keepGoing && !options.keepGoing()) return std::nullopt;
  }
  return parametersOf(optimizer.best());
}

}  // namespace

double predictionError(std::span<const ObservedStep> steps, const ModelParameters& parameters) {
  constexpr double position = 0.005, velocity = 0.05;  // [m, m/s]
  double sum = 0;
  std::size_t count = 0;
  for (const ObservedStep& step : steps) {
    const LinearInvertedPendulum model = step.pendulum.with(parameters);
    // The middle of the step and its end show as much as all samples.
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
  std::vector<ObservedStep> fitted, leftOut;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].samples.empty()) continue;
    (i % 3 == 2 ? leftOut : fitted).push_back(steps[i]);
  }
  ModelFitResult result;
  result.parameters = before;
  result.prediction = options.prediction;
  result.before = result.after = predictionError(fitted, before);
  result.leftOutBefore = result.leftOutAfter = predictionError(leftOut, before);
  result.predictionLeftOutBefore = result.predictionLeftOutAfter =
      predictionError(leftOut, options.prediction);
  if (fitted.empty() || leftOut.empty()) return result;

  // Every change costs a little, so parameters that the steps do not determine stay as they were.
  constexpr double weight = 0.03, weightOfChange = 0.05, weightOfDanger = 10;
  const auto costOf = [&](const Eigen::VectorXd& x) {
    return predictionError(fitted, parametersOf(x)) + weight * x.squaredNorm() / ModelParameters::count;
  };
  // Steps of one kind of walking determine some parameters badly, so none used for planning goes far in one
  // fit.
  constexpr double furthestPlanned = 2, anywhere = std::numeric_limits<double>::infinity();
  const auto predicting =
      search(spaceFrom(options.prediction, anywhere), options, result.bestPrediction, costOf);
  if (!predicting) return result;
  result.predictionLeftOutAfter = predictionError(leftOut, *predicting);
  result.predicts = result.predictionLeftOutAfter < result.predictionLeftOutBefore;
  if (result.predicts) result.prediction = *predicting;
  if (!options.plan) return result;

  const FitSafety safety(steps);
  const auto planned = search(spaceFrom(before, furthestPlanned), options, result.best, [&](const auto& x) {
    const double change = safety.change(parametersOf(x));
    return costOf(x) + weightOfChange * change * change + weightOfDanger * std::max(0.0, change - 1);
  });
  if (!planned) return result;
  result.after = predictionError(fitted, *planned);
  result.leftOutAfter = predictionError(leftOut, *planned);
  result.change = safety.change(*planned);
  result.accepted =
      result.leftOutAfter < result.leftOutBefore && result.after < result.before && result.change <= 1;
  if (result.accepted) result.parameters = *planned;
  return result;
}

}  // namespace plumbline::walking
