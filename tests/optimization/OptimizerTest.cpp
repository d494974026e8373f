#include "optimization/Optimizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "optimization/Cmaes.h"

namespace plumbline {
namespace {

using Eigen::VectorXd;

std::string errorOf(const SearchSpace& space) {
  try {
    Cmaes cmaes(space);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(Optimizer, badSpacesAreNamed) {
  SearchSpace space = SearchSpace::box(VectorXd::Constant(3, -1), VectorXd::Constant(3, 1));
  EXPECT_EQ(errorOf(space), "no error");
  space.sigma[1] = 0;
  EXPECT_EQ(errorOf(space), "search space: sigma of coordinate 1 is 0.000000");
  space.sigma[1] = 1;
  space.start[2] = 2;
  EXPECT_EQ(errorOf(space), "search space: the start, outside its bounds, of coordinate 2 is 2.000000");
  space.start[2] = std::nan("");
  EXPECT_EQ(errorOf(space), "search space: the start of coordinate 2 is nan");
  space.start[2] = 0;
  space.lower[0] = 1;
  EXPECT_EQ(errorOf(space),
            "search space: the lower bound, not below the upper, of coordinate 0 is 1.000000");
  space.lower = VectorXd::Constant(2, -1);
  EXPECT_EQ(errorOf(space), "search space: 2 numbers for 3 coordinates");
  EXPECT_EQ(errorOf({}), "search space: no coordinates");
}

TEST(Optimizer, askGivesTheSameUntilTell) {
  Cmaes cmaes(SearchSpace::around(VectorXd::Constant(3, 1), 0.5));
  const Eigen::MatrixXd first = cmaes.ask();
  EXPECT_EQ(cmaes.ask(), first);
  std::vector<double> costs(static_cast<std::size_t>(first.cols()), 5.0);
  costs[4] = 2;
  cmaes.tell(costs);
  EXPECT_EQ(cmaes.best(), first.col(4));
  EXPECT_EQ(cmaes.bestCost(), 2);
  EXPECT_EQ(cmaes.evaluations(), first.cols());
  EXPECT_NE(cmaes.ask(), first);
}

TEST(Optimizer, tellNeedsAsManyCostsAsCandidates) {
  Cmaes cmaes(SearchSpace::around(VectorXd::Constant(3, 1), 0.5));
  EXPECT_THROW(cmaes.tell(std::vector<double>(7, 0.0)), std::logic_error);
  cmaes.ask();
  try {
    cmaes.tell(std::vector<double>(6, 0.0));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "Optimizer::tell: 6 costs for 7 candidates");
  }
}

}  // namespace
}  // namespace plumbline
