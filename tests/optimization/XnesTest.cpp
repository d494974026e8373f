#include "optimization/Xnes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "optimization/Functions.h"

namespace plumbline {
namespace {

using Eigen::VectorXd;

std::int64_t evaluationsTo1e8(double (*cost)(const VectorXd&), double start) {
  std::vector<std::int64_t> counts;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    XnesOptions options;
    options.seed = seed;
    options.stop.targetCost = 1e-8;
    options.stop.maxEvaluations = 200'000;
    Xnes xnes(SearchSpace::around(VectorXd::Constant(10, start), 0.5), options);
    minimize(xnes, cost);
    EXPECT_EQ(xnes.stopReason(), StopReason::targetCost) << "seed " << seed;
    counts.push_back(xnes.evaluations());
  }
  std::sort(counts.begin(), counts.end());
  return counts[1];
}

// The bounds are the evaluations of pagmo's xnes.
TEST(Xnes, takesNoMoreEvaluationsThanPagmo) {
  EXPECT_LE(evaluationsTo1e8(sphere, 1), 15'500);
  EXPECT_LE(evaluationsTo1e8(ellipsoid, 1), 21'900);
  EXPECT_LE(evaluationsTo1e8(rosenbrock, 0), 22'200);
}

TEST(Xnes, populationLargerThanTheSpaceAndBounds) {
  XnesOptions options;
  options.population = 20;
  options.stop.maxGenerations = 400;
  Xnes xnes(SearchSpace::box(VectorXd::Constant(3, 0.5), VectorXd::Constant(3, 4)), options);
  while (!xnes.isDone()) {
    const Eigen::MatrixXd& candidates = xnes.ask();
    ASSERT_GE(candidates.minCoeff(), 0.5);
    ASSERT_LE(candidates.maxCoeff(), 4);
    std::vector<double> costs;
    for (Eigen::Index k = 0; k < candidates.cols(); ++k) costs.push_back(sphere(candidates.col(k)));
    xnes.tell(costs);
  }
  EXPECT_NEAR(xnes.bestCost(), 0.75, 1e-8);
}

TEST(Xnes, sameSeedSameBytesAndNaNIsWorst) {
  const auto run = [](std::uint64_t seed) {
    XnesOptions options;
    options.seed = seed;
    options.stop.targetCost = 1e-6;
    options.stop.maxEvaluations = 50'000;
    Xnes xnes(SearchSpace::around(VectorXd::Constant(5, 2), 0.5), options);
    minimize(xnes, [](const VectorXd& x) { return x[0] < 0 ? std::nan("") : sphere(x); });
    EXPECT_EQ(xnes.stopReason(), StopReason::targetCost);
    return xnes.best();
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST(Xnes, stopsOnAPlateau) {
  Xnes xnes(SearchSpace::around(VectorXd::Constant(4, 1), 0.5));
  minimize(xnes, [](const VectorXd&) { return 3.0; });
  EXPECT_EQ(xnes.stopReason(), StopReason::tolFun);
}

}  // namespace
}  // namespace plumbline
