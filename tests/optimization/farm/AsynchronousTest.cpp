#include <gtest/gtest.h>

#include <algorithm>

#include "../Functions.h"
#include "SimulatedFarm.h"
#include "optimization/Cmaes.h"

namespace plumbline::farm {
namespace {

using Eigen::VectorXd;
using Function = double (*)(const VectorXd&);

Search cmaes(int dimension, double start, int population, int ahead, std::uint64_t seed) {
  CmaesOptions options;
  options.population = population;
  options.ahead = ahead;
  options.seed = seed;
  options.stop.targetCost = 1e-8;
  options.stop.maxEvaluations = 100'000;
  return {std::make_unique<Cmaes>(SearchSpace::around(VectorXd::Constant(dimension, start), 0.5), options),
          Averaging{}, seed};
}

struct Median {
  double evaluations, efficiency;
};

Median median(Function f, int dimension, double start, int population, int ahead) {
  std::vector<double> evaluations, efficiency;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Search search = cmaes(dimension, start, population, ahead, seed);
    SimulatedFarm farm;
    farm.seed = seed;
    const auto result = farm.run(search, [f](const Trial& trial) { return f(trial.parameters); });
    EXPECT_LE(search.optimizer().bestCost(), 1e-8);
    evaluations.push_back(static_cast<double>(search.trials()));
    efficiency.push_back(result.efficiency);
  }
  for (auto* values : {&evaluations, &efficiency}) std::ranges::sort(*values);
  return {evaluations[2], efficiency[2]};
}

struct Case {
  const char* name;
  Function function;
  int dimension;
  double start;
};

class Asynchronous : public testing::TestWithParam<Case> {};

/// 30 workers, times of 30 % deviation: with a barrier they wait for the slowest of each generation.
TEST_P(Asynchronous, keepsThirtyWorkersBusyForAFewMoreEvaluations) {
  const Case c = GetParam();
  const Median barrier = median(c.function, c.dimension, c.start, 30, 1);
  const Median ours = median(c.function, c.dimension, c.start, 18, 3);
  EXPECT_LT(barrier.efficiency, 0.7);
  EXPECT_GE(ours.efficiency, 0.95);
  EXPECT_LE(ours.evaluations, 1.1 * barrier.evaluations);
}

INSTANTIATE_TEST_SUITE_P(Functions, Asynchronous,
                         testing::Values(Case{"sphere", sphere, 10, 1},
                                         Case{"rosenbrock", rosenbrock, 10, 0}),
                         [](const auto& info) {
                           return info.param.name + std::to_string(info.param.dimension);
                         });

}  // namespace
}  // namespace plumbline::farm
