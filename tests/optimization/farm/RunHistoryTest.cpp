#include "optimization/farm/RunHistory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimization/Optimizers.h"

namespace plumbline::farm {
namespace {

double sphere(const Trial& trial) { return trial.parameters.squaredNorm(); }

Search makeSearch() {
  OptimizerOptions options;
  options.population = 8;
  return {makeOptimizer("cmaes", SearchSpace::around(Eigen::VectorXd::Ones(3), 1), options), Averaging{}, 1};
}

TEST(RunHistoryTest, hasAPointForEachGeneration) {
  Search search = makeSearch();
  RunHistory history(search);
  double sum = 0;
  for (int i = 0; i < 24; ++i) {
    const Trial trial = *search.next();
    const double cost = sphere(trial);
    if (i < 8) sum += cost;
    history.addResult(std::vector<double>{cost});
    search.tell(trial.number, std::vector<double>{cost});
  }
  history.look();
  ASSERT_EQ(history.points().size(), 3u);
  EXPECT_EQ(history.points()[0].generation, 1);
  EXPECT_EQ(history.points()[2].runs, 24);
  EXPECT_NEAR(history.points()[0].mean, sum / 8, 1e-12);
  EXPECT_EQ(history.points()[2].best, search.optimizer().bestCost());
  EXPECT_LE(history.points()[2].best, history.points()[0].best);
}

TEST(RunHistoryTest, whatIsNoNumberIsNotInTheMean) {
  Search search = makeSearch();
  RunHistory history(search);
  for (int i = 0; i < 8; ++i) {
    const Trial trial = *search.next();
    const std::vector<double> costs{i < 4 ? std::nan("") : 2.0};
    history.addResult(costs);
    search.tell(trial.number, costs);
  }
  history.look();
  ASSERT_EQ(history.points().size(), 1u);
  EXPECT_EQ(history.points()[0].mean, 2);
}

TEST(RunHistoryTest, aLongSearchKeepsItsLastPointAndABoundedNumber) {
  Search search = makeSearch();
  RunHistory history(search);
  double cost = 1e6;
  std::int64_t generations = 0;
  while (generations < 2100 && !search.isDone()) {
    const Trial trial = *search.next();
    cost *= 0.9999;
    history.addResult(std::vector<double>{cost + sphere(trial)});
    search.tell(trial.number, std::vector<double>{cost + sphere(trial)});
    generations = search.optimizer().generations();
  }
  history.look();
  EXPECT_LE(history.points().size(), RunHistory::most);
  EXPECT_EQ(history.points().back().generation, generations);
}

}  // namespace
}  // namespace plumbline::farm
