#include "training/tasks/StandUpTask.h"

#include <gtest/gtest.h>

namespace plumbline::training {
namespace {

using Options = std::map<std::string, std::string>;

TEST(StandUpTask, aRunDependsOnParametersAndSeedAlone) {
  StandUpTask used{StandUpOptions()}, fresh{StandUpOptions()};
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
  StandUpTask walks{StandUpOptions()}, stands(TaskOptions(Options{{"still", "1"}}).as<StandUpOptions>()),
      some(TaskOptions(Options{{"still", "0.5"}}).as<StandUpOptions>());
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

/// As in play the motion begins while the robot still moves, and the run is the same again.
TEST(StandUpTask, beginsWithTheMotionOfTheFallWhereThatIsAskedFor) {
  StandUpTask rests{StandUpOptions()}, moves(TaskOptions(Options{{"start", "fall"}}).as<StandUpOptions>()),
      again(TaskOptions(Options{{"start", "fall"}}).as<StandUpOptions>());
  for (std::uint64_t seed = 2; seed <= 3; ++seed) {  // dropped, pushed while it walks
    const double rested = rests.tryMotion(rests.first(), seed).cost;
    const double moved = moves.tryMotion(moves.first(), seed).cost;
    EXPECT_NE(rested, moved);
    EXPECT_EQ(moved, again.tryMotion(again.first(), seed).cost);
  }
}

TEST(StandUpTask, fromTheSideItRollsAndStandsUpAndTheTimeIsOfBoth) {
  StandUpTask task(TaskOptions(Options{{"direction", "side"}, {"start", "fall"}}).as<StandUpOptions>());
  EXPECT_EQ(task.first().name, "rollOver");
  double up = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto outcome = task.tryMotion(task.first(), seed);
    std::map<std::string, double> figures(outcome.figures.begin(), outcome.figures.end());
    up += figures["up"];
    EXPECT_GT(figures["time"], 1e3 * task.first().seconds() + 400) << seed;
  }
  EXPECT_GE(up, 8);
}

}  // namespace
}  // namespace plumbline::training
