#include "training/tasks/StandUpTask.h"

#include <gtest/gtest.h>

namespace plumbline::training {
namespace {

using Options = std::map<std::string, std::string>;

TEST(StandUpTask, aRunDependsOnParametersAndSeedAlone) {
  StandUpTask used{TaskOptions()}, fresh{TaskOptions()};
  Eigen::VectorXd x(static_cast<Eigen::Index>(used.parameters().size()));
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = used.parameters()[static_cast<std::size_t>(i)].start;
  const Eigen::VectorXd other = 0.9 * x;
  for (std::uint64_t seed = 20; seed < 22; ++seed) used.run(other, seed);
  const TaskOutcome a = used.run(x, 7), b = fresh.run(x, 7);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.figures, b.figures);
  used.run(other, 7);
  EXPECT_EQ(used.run(x, 7).cost, b.cost);
}

/// The fall and the motion are the same; what follows is another.
TEST(StandUpTask, standsStillAfterwardsInTheShareOfRunsThatIsAskedFor) {
  StandUpTask walks{TaskOptions()}, stands(TaskOptions(Options{{"still", "1"}})),
      some(TaskOptions(Options{{"still", "0.5"}}));
  int stood = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const double walked = walks.tryMotion(walks.first(), seed).cost;
    const double still = stands.tryMotion(stands.first(), seed).cost;
    const double either = some.tryMotion(some.first(), seed).cost;
    EXPECT_NE(walked, still);
    EXPECT_TRUE(either == walked || either == still);
    stood += either == still;
  }
  EXPECT_GT(stood, 0);
  EXPECT_LT(stood, 6);
}

}  // namespace
}  // namespace plumbline::training
