#include "modules/behavior/formation/Assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "math/Random.h"

using namespace plumbline;

namespace {

TEST(AssignmentTest, isAsCheapAsTheBestOfAllPermutations) {
  Random random(5);
  for (int run = 0; run < 60; ++run) {
    const std::size_t workers = 1 + run % 6, jobs = workers + static_cast<std::size_t>(run) % 2;
    std::vector<std::vector<double>> cost(workers, std::vector<double>(jobs));
    for (auto& row : cost)
      for (double& value : row) value = random.uniform(-5, 20);
    const std::vector<int> found = assign(cost);
    double sum = 0;
    for (std::size_t i = 0; i < workers; ++i) sum += cost[i][static_cast<std::size_t>(found[i])];
    std::vector<std::size_t> order(jobs);
    std::iota(order.begin(), order.end(), 0u);
    double best = 1e9;
    do {
      double total = 0;
      for (std::size_t i = 0; i < workers; ++i) total += cost[i][order[i]];
      best = std::min(best, total);
    } while (std::ranges::next_permutation(order).found);
    EXPECT_NEAR(sum, best, 1e-9);
    std::vector<int> sorted = found;
    std::ranges::sort(sorted);
    EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
  }
}

TEST(AssignmentTest, nobodyAndTooFewJobs) {
  EXPECT_TRUE(assign({}).empty());
  EXPECT_THROW(assign({{1}, {2}}), std::invalid_argument);
}

}  // namespace
