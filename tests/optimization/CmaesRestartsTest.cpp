#include "optimization/CmaesRestarts.h"

#include <gtest/gtest.h>

#include "optimization/Functions.h"

namespace plumbline {
namespace {

using Eigen::VectorXd;

CmaesRestarts search(CmaesRestarts::Kind kind, int restarts, std::uint64_t seed = 1) {
  CmaesOptions options;
  options.seed = seed;
  options.stop.targetCost = 1e-8;
  options.stop.maxEvaluations = 300'000;
  return {SearchSpace::box(VectorXd::Constant(6, -5), VectorXd::Constant(6, 5)), options, kind, restarts};
}

TEST(CmaesRestarts, findTheLowestOfManyMinima) {
  for (const auto kind : {CmaesRestarts::Kind::ipop, CmaesRestarts::Kind::bipop})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      CmaesRestarts once = search(kind, 0, seed), often = search(kind, 20, seed);
      EXPECT_GT(minimize(once, rastrigin), 0.5) << "no restart was needed";
      minimize(often, rastrigin);
      EXPECT_EQ(often.stopReason(), StopReason::targetCost);
      EXPECT_GT(often.restartsDone(), 0);
    }
}

TEST(CmaesRestarts, populationDoubles) {
  CmaesRestarts ipop = search(CmaesRestarts::Kind::ipop, 2);
  EXPECT_EQ(ipop.population(), 9);
  minimize(ipop, [](const VectorXd&) { return 1.0; });
  EXPECT_EQ(ipop.restartsDone(), 2);
  EXPECT_EQ(ipop.population(), 36);
  EXPECT_EQ(ipop.stopReason(), StopReason::tolFun);
}

/// The first deviation is half of the distance between minima, and nothing bounds the place.
TEST(CmaesRestarts, restartsWithoutBoundsReachFartherThanTheFirstDeviation) {
  for (const auto kind : {CmaesRestarts::Kind::ipop, CmaesRestarts::Kind::bipop})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      CmaesOptions options;
      options.seed = seed;
      options.population = 50;
      options.stop.targetCost = 1e-8;
      options.stop.maxEvaluations = 200'000;
      CmaesRestarts often(SearchSpace::around(VectorXd::Constant(6, 2), 0.3), options, kind);
      minimize(often, rastrigin);
      EXPECT_EQ(often.stopReason(), StopReason::targetCost) << "seed " << seed;
    }
}

TEST(CmaesRestarts, limitsCountAllRuns) {
  CmaesOptions options;
  options.stop.maxEvaluations = 2000;
  CmaesRestarts ipop(SearchSpace::box(VectorXd::Constant(6, -5), VectorXd::Constant(6, 5)), options);
  minimize(ipop, [](const VectorXd&) { return 1.0; });
  EXPECT_EQ(ipop.stopReason(), StopReason::maxEvaluations);
  EXPECT_GE(ipop.evaluations(), 2000);
  EXPECT_LT(ipop.evaluations(), 2144);
}

}  // namespace
}  // namespace plumbline
