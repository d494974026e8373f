#include "training/tasks/DiveTask.h"

#include <gtest/gtest.h>

#include "framework/ConfigurationError.h"

namespace plumbline::training {
namespace {

using DiveOptions = std::map<std::string, std::string>;

Eigen::VectorXd diveOf(const SearchTask& task) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(task.parameters().size()));
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = task.parameters()[static_cast<std::size_t>(i)].start;
  return x;
}

/// Of 20 shots the number of saves.
int saves(DiveTask& task, const Eigen::VectorXd& parameters) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const auto& [name, value] : task.run(parameters, seed).figures)
      if (name == "saved") count += value > 0;
  return count;
}

TEST(DiveTask, theDiveSavesMostShotsInItsReach) {
  for (const char* type : {"0", "4"}) {
    DiveTask task{TaskOptions(DiveOptions{{"type", type}})};
    EXPECT_GE(saves(task, diveOf(task)), 10) << type;
  }
}

TEST(DiveTask, whoDoesNotMoveSavesNone) {
  DiveTask late{TaskOptions(DiveOptions{{"reaction", "2"}})};
  EXPECT_EQ(saves(late, diveOf(late)), 0);
  DiveTask atTheFeet{TaskOptions(DiveOptions{{"reaction", "2"}, {"from", "-0.05"}, {"to", "0.05"}})};
  EXPECT_GE(saves(atTheFeet, diveOf(atTheFeet)), 18);
  DiveTask aside{TaskOptions(DiveOptions{{"from", "1.6"}, {"to", "2"}})};
  EXPECT_EQ(saves(aside, diveOf(aside)), 0) << "out of reach";
}

TEST(DiveTask, aRunDependsOnParametersAndSeedAlone) {
  DiveTask used{TaskOptions()}, fresh{TaskOptions()};
  const Eigen::VectorXd dive = diveOf(used);
  used.run(dive, 8);
  const TaskOutcome a = used.run(dive, 9), b = fresh.run(dive, 9);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.figures, b.figures);
}

TEST(DiveTask, tellsAMotionThatThereIsNot) {
  try {
    DiveTask task{TaskOptions(DiveOptions{{"motion", "divLeft"}})};
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(), "option motion: no motion divLeft");
  }
}

}  // namespace
}  // namespace plumbline::training
