#include "optimization/Search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Functions.h"
#include "math/Random.h"
#include "optimization/Optimizers.h"

namespace plumbline {
namespace {

using Eigen::VectorXd;

Search searchBy(const char* name, const Averaging& averaging = {}, int ahead = 1) {
  OptimizerOptions options;
  options.population = 8;
  options.ahead = ahead;
  options.stop.maxGenerations = 30;
  return {makeOptimizer(name, SearchSpace::box(VectorXd::Constant(4, -2), VectorXd::Constant(4, 3)), options),
          averaging, 7};
}

std::vector<double> costsOf(const Trial& trial) {
  std::vector<double> costs;
  for (const std::uint64_t seed : trial.seeds)
    costs.push_back(sphere(trial.parameters) + 1e-10 * static_cast<double>(seed));
  return costs;
}

/// All that may be handed out gets its result in an order that the seed shuffles.
void runShuffled(Search& search, std::uint64_t seed) {
  Random random(seed);
  std::vector<Trial> open;
  while (!search.isDone()) {
    while (const auto trial = search.next()) open.push_back(*trial);
    const std::size_t i = random.next() % open.size();
    ASSERT_EQ(search.tell(open[i].number, costsOf(open[i])), ResultStatus::taken);
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

TEST(Search, theOrderOfResultsHasNoEffectWhateverTheOptimiser) {
  for (const std::string& name : optimizerNames())
    for (const Averaging& averaging : {Averaging{}, Averaging{2, 5}}) {
      Search one = searchBy(name.c_str(), averaging, 3), other = searchBy(name.c_str(), averaging, 3);
      runShuffled(one, 1);
      runShuffled(other, 2);
      EXPECT_EQ(one.optimizer().best(), other.optimizer().best()) << name;
      EXPECT_TRUE(one.optimizer().save() == other.optimizer().save()) << name;
    }
}

TEST(Search, aResultCountsOnce) {
  Search search = searchBy("cmaes");
  const Trial trial = *search.next();
  const double cost = 1;
  EXPECT_EQ(search.tell(trial.number, {&cost, 1}), ResultStatus::taken);
  EXPECT_EQ(search.tell(trial.number, {&cost, 1}), ResultStatus::again);
  EXPECT_EQ(search.giveUp(trial.number), ResultStatus::again);
  EXPECT_EQ(search.tell(1'000'000'000'000, {&cost, 1}), ResultStatus::unknown);
  EXPECT_EQ(search.tell(-4, {&cost, 1}), ResultStatus::unknown);
  EXPECT_FALSE(search.find(trial.number));
  EXPECT_EQ(search.trials(), 1);
}

TEST(Search, aWrongNumberOfCostsIsAnError) {
  Search search = searchBy("cmaes");
  const Trial trial = *search.next();
  try {
    search.tell(trial.number, std::vector<double>(2, 0.0));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "2 costs for 1 runs");
  }
  EXPECT_TRUE(search.find(trial.number)) << "its result may still come";
}

TEST(Search, whatIsNoNumberAndWhatNobodyTellsIsCountedAndHarmless) {
  Search search = searchBy("cmaes");
  for (int i = 0; !search.isDone(); ++i) {
    const auto trial = search.next();
    ASSERT_TRUE(trial);
    std::vector<double> costs = costsOf(*trial);
    if (i % 10 == 0) costs[0] = std::nan("");
    if (i % 10 == 1) costs[0] = -HUGE_VAL;
    if (i % 10 == 2)
      search.giveUp(trial->number);
    else
      search.tell(trial->number, costs);
  }
  EXPECT_EQ(search.trials(), 240);
  EXPECT_EQ(search.notNumbers(), 24);
  EXPECT_EQ(search.givenUp(), 24);
  EXPECT_LT(search.optimizer().bestCost(), 0.5);
  EXPECT_TRUE(std::isfinite(search.optimizer().bestCost()));
}

TEST(Search, theBetterHalfIsRunMore) {
  Search search = searchBy("cmaes", {2, 10});
  std::vector<Trial> first;
  while (const auto trial = search.next()) first.push_back(*trial);
  ASSERT_EQ(first.size(), 8U);
  EXPECT_EQ(first[0].seeds, first[5].seeds) << "what differs is the candidates' own";
  for (const Trial& trial : first) {
    ASSERT_EQ(trial.seeds.size(), 2U);
    search.tell(trial.number, costsOf(trial));
  }
  std::ranges::sort(first, {}, [](const Trial& t) { return sphere(t.parameters); });
  std::vector<std::int64_t> again, best;
  while (const auto trial = search.next()) {
    again.push_back(trial->candidate);
    EXPECT_EQ(trial->seeds.size(), 8U);
    EXPECT_EQ(std::ranges::count(trial->seeds, first[0].seeds[0]), 0) << "another seed";
  }
  for (int i = 0; i < 4; ++i) best.push_back(first[static_cast<std::size_t>(i)].candidate);
  std::ranges::sort(again);
  std::ranges::sort(best);
  EXPECT_EQ(again, best);
}

TEST(Search, badRunsAreNamed) {
  const auto errorOf = [](const Averaging& averaging) -> std::string {
    try {
      searchBy("cmaes", averaging);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(errorOf({0, 1}), "a candidate is run 0 times; 1 to 10000 are possible");
  EXPECT_EQ(errorOf({5, 2}), "the best are run 2 times, fewer than all, 5");
}

}  // namespace
}  // namespace plumbline
