#include "optimization/farm/Dispatcher.h"

#include <gtest/gtest.h>

#include <set>

#include "../Functions.h"
#include "SimulatedFarm.h"
#include "optimization/Cmaes.h"

namespace plumbline::farm {
namespace {

using Eigen::VectorXd;

Search dispatchedSearch(std::int64_t generations, int ahead = 3, Averaging averaging = {}) {
  CmaesOptions options;
  options.population = 18;
  options.ahead = ahead;
  options.stop.maxGenerations = generations;
  options.stop.tolFun = options.stop.tolX = 0;
  return {std::make_unique<Cmaes>(SearchSpace::around(VectorXd::Constant(6, 1), 0.5), options), averaging, 3};
}

double cost(const Trial& trial) { return sphere(trial.parameters); }

void runAlone(Search& alone) {
  while (!alone.isDone()) {
    const Trial trial = *alone.next();
    alone.tell(trial.number, std::vector<double>(trial.seeds.size(), cost(trial)));
  }
}

TEST(Dispatcher, aThousandKillsLoseNothingAndCountNothingTwice) {
  Search disturbed = dispatchedSearch(250, 3, {1, 2}), alone = dispatchedSearch(250, 3, {1, 2});
  SimulatedFarm farm;
  farm.kills = 0.14;
  farm.hangs = 0.005;
  farm.lies = 0.02;
  farm.nonsense = 0.02;
  std::set<std::int64_t> counted;
  const auto result = farm.run(disturbed, cost, [&](const Trial& trial, std::span<const double> costs, int) {
    EXPECT_TRUE(counted.insert(trial.number).second) << "counted twice";
    EXPECT_EQ(costs.size(), trial.seeds.size()) << "given up";
  });
  EXPECT_GE(result.killed, 1000);
  EXPECT_GE(result.hung, 20);
  EXPECT_GE(result.lied, 100);
  EXPECT_GE(result.counts.doubted, 100);
  // What counted is what one process alone would have evaluated, and so is what was learnt, unless two
  // workers in a row took the same parameters for nonsense.
  runAlone(alone);
  EXPECT_EQ(static_cast<std::int64_t>(counted.size()), disturbed.trials());
  EXPECT_EQ(disturbed.optimizer().generations(), 250);
  EXPECT_LE(disturbed.notNumbers(), 10);
  EXPECT_LT(disturbed.optimizer().bestCost(), 1e-8);
}

TEST(Dispatcher, killsAndHangsAloneChangeNothingAtAll) {
  Search disturbed = dispatchedSearch(60), alone = dispatchedSearch(60);
  SimulatedFarm farm;
  farm.kills = 0.3;
  farm.hangs = 0.02;
  farm.lies = 0.05;
  farm.run(disturbed, cost);
  runAlone(alone);
  EXPECT_TRUE(disturbed.optimizer().save() == alone.optimizer().save());
}

TEST(Dispatcher, theFirstAnswerCountsWhenAHangingWorkerWakesUp) {
  Search search_ = dispatchedSearch(5);
  Dispatcher dispatcher(search_, {.patience = 5, .mostFailures = 10});
  const int slow = dispatcher.join(), quick = dispatcher.join();
  const Trial trial = *dispatcher.give(slow, 0);
  dispatcher.expire(4.9);
  EXPECT_NE(dispatcher.give(quick, 4.9)->number, trial.number);
  dispatcher.take(quick, dispatcher.counts().answers, {});  // not its trial
  EXPECT_EQ(dispatcher.counts().wrong, 1);
  dispatcher.leave(quick);
  dispatcher.expire(5);
  const int third = dispatcher.join();
  EXPECT_EQ(dispatcher.give(third, 5)->number, trial.number);
  const double first = 1, second = 2;
  EXPECT_EQ(dispatcher.take(slow, trial.number, {&first, 1}), Taken::counted);
  EXPECT_EQ(dispatcher.take(third, trial.number, {&second, 1}), Taken::again);
  EXPECT_EQ(dispatcher.counts().hung, 1);
}

TEST(Dispatcher, whatIsNoNumberIsAskedOfAnotherWorkerOnce) {
  Search search_ = dispatchedSearch(5);
  Dispatcher dispatcher(search_, {});
  const int one = dispatcher.join(), other = dispatcher.join();
  const double nothing = std::nan("");
  const Trial trial = *dispatcher.give(one, 0);
  EXPECT_EQ(dispatcher.take(one, trial.number, {&nothing, 1}), Taken::asksMore);
  EXPECT_EQ(dispatcher.give(other, 1)->number, trial.number);
  EXPECT_EQ(dispatcher.take(other, trial.number, {&nothing, 1}), Taken::counted);
  EXPECT_EQ(search_.notNumbers(), 1);
}

TEST(Dispatcher, aTrialThatKillsEveryWorkerIsGivenUp) {
  Search search_ = dispatchedSearch(5);
  int given = 0;
  Dispatcher dispatcher(search_, {.patience = 5, .mostFailures = 3},
                        [&](const Trial&, std::span<const double> costs, int worker) {
                          given += costs.empty() && worker == -1;
                        });
  const std::int64_t first = search_.find(0)->number;
  for (int i = 0; i < 3; ++i) {
    const int worker = dispatcher.join();
    EXPECT_EQ(dispatcher.give(worker, i)->number, first);
    dispatcher.leave(worker);
  }
  EXPECT_EQ(given, 1);
  EXPECT_EQ(search_.givenUp(), 1);
  EXPECT_NE(dispatcher.give(dispatcher.join(), 4)->number, first);
}

}  // namespace
}  // namespace plumbline::farm
