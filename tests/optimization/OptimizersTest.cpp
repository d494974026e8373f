#include "optimization/Optimizers.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace plumbline {
namespace {

using Eigen::VectorXd;

double bowl(const VectorXd& x) { return (x - VectorXd::LinSpaced(x.size(), 0.5, 1.5)).squaredNorm(); }

std::vector<double> costsOf(const Eigen::MatrixXd& candidates) {
  std::vector<double> costs;
  for (Eigen::Index k = 0; k < candidates.cols(); ++k) costs.push_back(bowl(candidates.col(k)));
  return costs;
}

SearchSpace space() {
  SearchSpace space = SearchSpace::around(VectorXd::Zero(4), 0.5);
  space.lower = VectorXd::Constant(4, -2);
  space.upper = VectorXd::Constant(4, 2);
  return space;
}

TEST(Optimizers, areFoundByName) {
  EXPECT_EQ(optimizerNames(),
            (std::vector<std::string>{"cmaes", "sep-cmaes", "xnes", "pso", "ipop-cmaes", "bipop-cmaes"}));
  try {
    makeOptimizer("cmeas", space());
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(
        error.what(),
        "unknown optimiser \"cmeas\"; there are: cmaes, sep-cmaes, xnes, pso, ipop-cmaes, bipop-cmaes");
  }
}

class EachOptimizer : public testing::TestWithParam<std::string> {
protected:
  std::unique_ptr<Optimizer> make(std::uint64_t seed = 3) const {
    return makeOptimizer(GetParam(), space(), {.population = 12, .seed = seed, .stop = {}});
  }
};

TEST_P(EachOptimizer, takesTheCostsAndFindsTheLeast) {
  const std::unique_ptr<Optimizer> optimizer = make();
  EXPECT_EQ(optimizer->ask().cols(), 12);
  optimizer->tell(costsOf(optimizer->ask()));
  EXPECT_GT(optimizer->sigma(), 0.3);
  for (int i = 0; i < 150 && !optimizer->isDone(); ++i) optimizer->tell(costsOf(optimizer->ask()));
  EXPECT_LT(optimizer->bestCost(), 1e-4);
  EXPECT_NE(make(4)->ask(), make(5)->ask());
}

TEST_P(EachOptimizer, goesOnFromWhatItSavedToTheSameBytes) {
  const std::unique_ptr<Optimizer> whole = make(), half = make(), rest = make();
  for (int i = 0; i < 7; ++i) {
    whole->tell(costsOf(whole->ask()));
    half->tell(costsOf(half->ask()));
  }
  rest->restore(half->save());
  EXPECT_EQ(rest->generations(), 7);
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(rest->ask(), whole->ask()) << "generation " << i;
    whole->tell(costsOf(whole->ask()));
    rest->tell(costsOf(rest->ask()));
  }
  EXPECT_EQ(rest->best(), whole->best());
  EXPECT_EQ(rest->save(), whole->save());
}

TEST_P(EachOptimizer, refusesWhatIsNoStateOfItsSearch) {
  const std::unique_ptr<Optimizer> optimizer = make();
  optimizer->tell(costsOf(optimizer->ask()));
  const std::string state = optimizer->save();
  EXPECT_THROW(make()->restore(""), std::invalid_argument);
  EXPECT_THROW(make()->restore("nonsense"), std::invalid_argument);
  EXPECT_THROW(make()->restore(state.substr(0, state.size() - 3)), std::invalid_argument);
  const std::unique_ptr<Optimizer> other =
      makeOptimizer(GetParam(), SearchSpace::around(VectorXd::Zero(2), 1), {.population = 12, .stop = {}});
  EXPECT_THROW(other->restore(state), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Optimizers, EachOptimizer, testing::ValuesIn(optimizerNames()),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace plumbline
