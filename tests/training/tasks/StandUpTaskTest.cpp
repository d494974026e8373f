#include "training/tasks/StandUpTask.h"

#include <gtest/gtest.h>

namespace plumbline::training {
namespace {

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

}  // namespace
}  // namespace plumbline::training
