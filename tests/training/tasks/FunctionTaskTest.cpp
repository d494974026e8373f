#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/SearchTasks.h"

namespace plumbline::training {
namespace {

TaskOutcome functionAt(std::map<std::string, std::string> options, const Eigen::VectorXd& x,
                       std::uint64_t seed = 1) {
  return makeTask("function", TaskOptions(std::move(options)))->run(x, seed);
}

TEST(FunctionTask, costsAreThoseOfTheTextbooks) {
  const Eigen::Vector3d x(1, 2, 0.5), ones(1, 1, 1);
  const auto cost = [](const char* function, const Eigen::Vector3d& at) {
    return functionAt({{"function", function}, {"dimension", "3"}}, at).cost;
  };
  EXPECT_NEAR(cost("sphere", x), 5.25, 1e-12);
  EXPECT_NEAR(cost("ellipsoid", x), 1 + 4000 + 250000, 1e-6);
  EXPECT_NEAR(cost("rastrigin", x), 1 + 4 + 20.25, 1e-9) << "cosines of 1, 1 and -1";
  EXPECT_NEAR(cost("rosenbrock", x), 100 + 1225 + 1, 1e-9);
  EXPECT_NEAR(cost("rosenbrock", ones), 0, 1e-12);
}

TEST(FunctionTask, runsTakeTheirTimeSpreadAroundItAndATenthAtLeast) {
  const int runs = 400;
  const auto pauses = [&](const char* spread) {
    std::vector<double> shares;
    for (int seed = 1; seed <= runs; ++seed)
      shares.push_back(figure(functionAt({{"dimension", "2"}, {"sleep", "1e-5"}, {"spread", spread}},
                                         Eigen::Vector2d::Zero(), static_cast<std::uint64_t>(seed)),
                              "slept") /
                       1e-5);
    return shares;
  };
  double sum = 0, squares = 0;
  for (const double share : pauses("0.2")) {
    sum += share;
    squares += (share - 1) * (share - 1);
  }
  EXPECT_NEAR(sum / runs, 1, 0.04) << "four deviations of a mean";
  EXPECT_NEAR(std::sqrt(squares / runs), 0.2, 0.04);
  const std::vector<double> wide = pauses("1");
  EXPECT_NEAR(*std::ranges::min_element(wide), 0.1, 1e-9);
  EXPECT_LT(*std::ranges::max_element(wide), 6);
}

}  // namespace
}  // namespace plumbline::training
