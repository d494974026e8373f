#include "optimization/Cmaes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "optimization/Functions.h"

namespace plumbline {
namespace {

using Eigen::VectorXd;

/// Median evaluations to 1e-8 over three seeds.
std::int64_t evaluationsTo1e8(double (*cost)(const VectorXd&), int n, double start) {
  std::vector<std::int64_t> counts;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CmaesOptions options;
    options.seed = seed;
    options.stop.targetCost = 1e-8;
    options.stop.maxEvaluations = 500'000;
    Cmaes cmaes(SearchSpace::around(VectorXd::Constant(n, start), 0.5), options);
    minimize(cmaes, cost);
    EXPECT_EQ(cmaes.stopReason(), StopReason::targetCost) << "seed " << seed;
    counts.push_back(cmaes.evaluations());
  }
  std::sort(counts.begin(), counts.end());
  return counts[1];
}

// The bounds are the evaluations libcmaes's active CMA-ES needs, in 40 dimensions plus a tenth.
TEST(Cmaes, tenDimensionsTakeNoMoreEvaluationsThanLibcmaes) {
  EXPECT_LE(evaluationsTo1e8(sphere, 10, 1), 1440);
  EXPECT_LE(evaluationsTo1e8(ellipsoid, 10, 1), 4230);
  EXPECT_LE(evaluationsTo1e8(rosenbrock, 10, 0), 5500);
}

TEST(Cmaes, fortyDimensionsTakeAboutTheEvaluationsOfLibcmaes) {
  EXPECT_LE(evaluationsTo1e8(sphere, 40, 1), 5370);
  EXPECT_LE(evaluationsTo1e8(ellipsoid, 40, 1), 48'400);
  EXPECT_LE(evaluationsTo1e8(rosenbrock, 40, 0), 63'800);
}

TEST(Cmaes, badCandidatesTeachToo) {
  std::int64_t count[2];
  for (const bool active : {false, true}) {
    CmaesOptions options;
    options.active = active;
    options.stop.targetCost = 1e-8;
    Cmaes cmaes(SearchSpace::around(VectorXd::Constant(10, 1), 0.5), options);
    minimize(cmaes, ellipsoid);
    count[active] = cmaes.evaluations();
  }
  EXPECT_LT(count[1], 0.85 * static_cast<double>(count[0]));
}

/// Variances after the first generation, by the tutorial's figure 6 and table 1 (Hansen 2016), where the
/// candidates are steps from the mean in deviations, best first. The step size is left out.
VectorXd variancesAfter(const Eigen::MatrixXd& steps) {
  const double n = static_cast<double>(steps.rows()), lambda = static_cast<double>(steps.cols());
  const Eigen::Index mu = steps.cols() / 2;
  VectorXd w(steps.cols());
  for (Eigen::Index i = 0; i < w.size(); ++i)
    w[i] = std::log((lambda + 1) / 2 / (static_cast<double>(i) + 1));
  const auto effective = [](const VectorXd& part) { return std::pow(part.sum(), 2) / part.squaredNorm(); };
  const double good = effective(w.head(mu)), bad = effective(w.tail(w.size() - mu));
  const double c1 = 2 / (std::pow(n + 1.3, 2) + good);
  const double cMu = std::min(1 - c1, 2 * (0.25 + good + 1 / good - 2) / (std::pow(n + 2, 2) + good));
  const double most = std::min({1 + c1 / cMu, 1 + 2 * bad / (good + 2), (1 - c1 - cMu) / (n * cMu)});
  w.head(mu) /= w.head(mu).sum();
  w.tail(w.size() - mu) *= most / -w.tail(w.size() - mu).sum();
  const VectorXd step = steps.leftCols(mu) * w.head(mu);
  const double cc = (4 + good / n) / (n + 4 + 2 * good / n);
  const double usual = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
  const bool longStep = std::sqrt(good) * step.norm() >= (1.4 + 2 / (n + 1)) * usual;  // then no path is kept
  const VectorXd path = (longStep ? 0 : std::sqrt(cc * (2 - cc) * good)) * step;
  const double kept = 1 - c1 - cMu * w.sum() + (longStep ? c1 * cc * (2 - cc) : 0);
  VectorXd variances = VectorXd::Constant(steps.rows(), kept) + c1 * path.cwiseAbs2();
  for (Eigen::Index i = 0; i < w.size(); ++i)
    variances += cMu * (w[i] > 0 ? w[i] : w[i] * n / steps.col(i).squaredNorm()) * steps.col(i).cwiseAbs2();
  return variances;
}

// In few dimensions another of the three bounds of what bad candidates take away is the least.
TEST(Cmaes, theFirstGenerationChangesTheVariancesAsTheTutorialSays) {
  for (const auto& [n, population] : {std::pair(10, 10), {3, 7}, {2, 60}, {20, 400}}) {
    CmaesOptions options;
    options.population = population;
    Cmaes cmaes(SearchSpace::around(VectorXd::Constant(n, 3), 0.5), options);
    Eigen::MatrixXd candidates = cmaes.ask();
    std::vector<std::pair<double, Eigen::Index>> order;
    std::vector<double> costs;
    for (Eigen::Index k = 0; k < candidates.cols(); ++k) {
      costs.push_back(sphere(candidates.col(k)));
      order.emplace_back(costs.back(), k);
    }
    std::sort(order.begin(), order.end());
    Eigen::MatrixXd steps(candidates.rows(), candidates.cols());
    for (std::size_t k = 0; k < order.size(); ++k)
      steps.col(static_cast<Eigen::Index>(k)) = (candidates.col(order[k].second).array() - 3) / 0.5;
    cmaes.tell(costs);
    const VectorXd expected = variancesAfter(steps), is = cmaes.deviations().cwiseAbs2();
    for (Eigen::Index i = 1; i < is.size(); ++i)
      EXPECT_NEAR(is[i] / is[0], expected[i] / expected[0], 1e-9) << n << " dimensions, " << i;
  }
}

TEST(Cmaes, noCandidateLeavesTheBoxAndTheBoundIsReached) {
  const VectorXd lower = VectorXd::Constant(6, 0.5), upper = VectorXd::Constant(6, 4.0);
  SearchSpace space = SearchSpace::box(lower, upper);
  space.upper[5] = std::numeric_limits<double>::infinity();
  Cmaes cmaes(space, {});
  while (!cmaes.isDone()) {
    const Eigen::MatrixXd& candidates = cmaes.ask();
    std::vector<double> costs;
    for (Eigen::Index k = 0; k < candidates.cols(); ++k) {
      ASSERT_GE(candidates.col(k).minCoeff(), 0.5);
      ASSERT_LE(candidates.col(k).head(5).maxCoeff(), 4.0);
      costs.push_back(ellipsoid(candidates.col(k)));
    }
    cmaes.tell(costs);
  }
  // The least value is in the corner of all lower bounds.
  EXPECT_NEAR(cmaes.bestCost(), ellipsoid(lower), 1e-6);
  EXPECT_TRUE(cmaes.favourite().isApprox(lower, 1e-6));
}

TEST(Cmaes, sameSeedSameBytesOtherSeedOtherBytes) {
  const auto run = [](std::uint64_t seed) {
    CmaesOptions options;
    options.seed = seed;
    options.stop.maxGenerations = 50;
    Cmaes cmaes(SearchSpace::around(VectorXd::Constant(7, 1), 0.5), options);
    minimize(cmaes, rosenbrock);
    return cmaes.save();
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST(Cmaes, aRestoredSearchGoesOnAsIfNothingHadHappened) {
  const auto fresh = [] {
    return std::make_unique<Cmaes>(SearchSpace::around(VectorXd::Constant(7, 0), 0.5), CmaesOptions{});
  };
  const auto steps = [](Cmaes& cmaes, int count) {
    for (int i = 0; i < count; ++i) {
      std::vector<double> costs;
      const Eigen::MatrixXd& candidates = cmaes.ask();
      for (Eigen::Index k = 0; k < candidates.cols(); ++k) costs.push_back(rosenbrock(candidates.col(k)));
      cmaes.tell(costs);
    }
  };
  const auto whole = fresh(), first = fresh(), second = fresh();
  steps(*whole, 60);
  steps(*first, 25);
  second->restore(first->save());
  EXPECT_EQ(second->evaluations(), 25 * first->population());
  EXPECT_EQ(second->bestCost(), first->bestCost());
  steps(*second, 35);
  EXPECT_EQ(second->save(), whole->save());
  EXPECT_EQ(second->best(), whole->best());
}

TEST(Cmaes, damagedStatesAreRefused) {
  Cmaes cmaes(SearchSpace::around(VectorXd::Constant(3, 0), 0.5));
  const std::string state = cmaes.save();
  for (std::size_t length = 0; length < state.size(); ++length)
    EXPECT_THROW(cmaes.restore(state.substr(0, length)), std::invalid_argument) << length;
  EXPECT_THROW(cmaes.restore(state + "x"), std::invalid_argument);
  Cmaes other(SearchSpace::around(VectorXd::Constant(4, 0), 0.5));
  EXPECT_THROW(other.restore(state), std::invalid_argument);
}

TEST(Cmaes, notANumberIsWorseThanAnything) {
  CmaesOptions options;
  options.stop.targetCost = 1e-8;
  options.stop.maxEvaluations = 20'000;
  Cmaes cmaes(SearchSpace::around(VectorXd::Constant(5, 2), 0.5), options);
  // Half of the space gives no number.
  minimize(cmaes, [](const VectorXd& x) { return x[0] < 0 ? std::nan("") : sphere(x); });
  EXPECT_EQ(cmaes.stopReason(), StopReason::targetCost);
}

TEST(Cmaes, aGenerationOfNothingButNaNIsForgotten) {
  Cmaes cmaes(SearchSpace::around(VectorXd::Constant(5, 2), 0.5));
  cmaes.ask();
  const std::vector<double> none(static_cast<std::size_t>(cmaes.population()), std::nan(""));
  cmaes.tell(none);
  EXPECT_EQ(cmaes.favourite(), VectorXd::Constant(5, 2));
  EXPECT_EQ(cmaes.best(), VectorXd::Constant(5, 2));
  EXPECT_EQ(cmaes.bestCost(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(cmaes.generations(), 1);
}

TEST(Cmaes, itStopsWhereNothingMoreCanBeLearnt) {
  Cmaes flat(SearchSpace::around(VectorXd::Constant(4, 1), 0.5));
  minimize(flat, [](const VectorXd&) { return 3.0; });
  EXPECT_EQ(flat.stopReason(), StopReason::tolFun);
  EXPECT_LT(flat.generations(), 100);
  Cmaes falling(SearchSpace::around(VectorXd::Constant(4, 1), 0.5));
  minimize(falling, [](const VectorXd& x) { return x[0]; });
  EXPECT_EQ(falling.stopReason(), StopReason::condition);
  CmaesOptions options;
  options.stop.maxEvaluations = 100;
  Cmaes limited(SearchSpace::around(VectorXd::Constant(4, 1), 0.5), options);
  minimize(limited, sphere);
  EXPECT_EQ(limited.stopReason(), StopReason::maxEvaluations);
  EXPECT_EQ(limited.evaluations(), 104);
}

TEST(Cmaes, oneDimensionWorks) {
  CmaesOptions options;
  options.stop.targetCost = 1e-10;
  Cmaes cmaes(SearchSpace::around(VectorXd::Constant(1, 3), 1), options);
  minimize(cmaes, sphere);
  EXPECT_EQ(cmaes.stopReason(), StopReason::targetCost);
}

TEST(Cmaes, smallPopulationsAreRefused) {
  CmaesOptions options;
  options.population = 3;
  try {
    Cmaes cmaes(SearchSpace::around(VectorXd::Constant(4, 1), 0.5), options);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "Cmaes: population 3, at least 4 are needed");
  }
}

}  // namespace
}  // namespace plumbline
