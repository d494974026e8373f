#include "optimization/SeparableCmaes.h"

#include <gtest/gtest.h>

#include "Functions.h"
#include "optimization/Cmaes.h"

namespace plumbline {
namespace {

using Eigen::VectorXd;

double evaluations(Optimizer& optimizer, double (*cost)(const VectorXd&)) {
  EXPECT_LE(minimize(optimizer, cost), 1e-8);
  return static_cast<double>(optimizer.evaluations());
}

OptimizerOptions options(std::uint64_t seed) {
  OptimizerOptions all;
  all.seed = seed;
  all.stop.targetCost = 1e-8;
  all.stop.maxEvaluations = 200'000;
  return all;
}

TEST(SeparableCmaes, learnsScalesInFarFewerEvaluationsThanTheWholeMatrix) {
  const SearchSpace space = SearchSpace::around(VectorXd::Constant(40, 1), 0.5);
  SeparableCmaes separable(space, options(1));
  CmaesOptions whole;
  whole.stop = options(1).stop;
  Cmaes cmaes(space, whole);
  EXPECT_LT(evaluations(separable, ellipsoid), 0.5 * evaluations(cmaes, ellipsoid));
}

TEST(SeparableCmaes, findsAMinimumOnItsBounds) {
  const SearchSpace space = SearchSpace::box(VectorXd::Constant(5, 0.5), VectorXd::Constant(5, 3));
  OptimizerOptions given = options(2);
  given.stop.targetCost = 5 * 0.25 + 1e-8;
  SeparableCmaes separable(space, given);
  minimize(separable, sphere);
  EXPECT_EQ(separable.stopReason(), StopReason::targetCost);
  EXPECT_GE(separable.best().minCoeff(), 0.5);
}

TEST(SeparableCmaes, goesOnFromWhatItSaved) {
  const SearchSpace space = SearchSpace::around(VectorXd::Constant(6, 1), 0.5);
  SeparableCmaes one(space, options(3)), other(space, options(3));
  const auto step = [](Optimizer& optimizer) {
    std::vector<double> costs;
    for (const auto& candidate : optimizer.ask().colwise()) costs.push_back(ellipsoid(candidate));
    optimizer.tell(costs);
  };
  for (int i = 0; i < 30; ++i) step(one);
  other.restore(one.save());
  for (int i = 0; i < 30; ++i) {
    step(one);
    step(other);
  }
  EXPECT_EQ(one.best(), other.best());
  EXPECT_TRUE(one.save() == other.save());
}

TEST(SeparableCmaes, thePopulationHasToBeFour) {
  OptimizerOptions given = options(1);
  given.population = 3;
  try {
    SeparableCmaes separable(SearchSpace::around(VectorXd::Zero(2), 1), given);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "SeparableCmaes: population 3, at least 4 are needed");
  }
}

}  // namespace
}  // namespace plumbline
