#include "training/tasks/DiveTask.h"

#include <gtest/gtest.h>

#include "support/SearchTasks.h"
#include "support/Thrown.h"

namespace plumbline::training {
namespace {

using Options = std::map<std::string, std::string>;

/// Of 20 shots the number of saves.
int saves(DiveTask& task, const Eigen::VectorXd& parameters) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) count += figure(task.run(parameters, seed), "saved") > 0;
  return count;
}

TEST(DiveTask, theDiveSavesMostShotsInItsReach) {
  for (const char* type : {"0", "4"}) {
    DiveTask task{TaskOptions(Options{{"type", type}}).as<DiveOptions>()};
    EXPECT_GE(saves(task, startOf(task)), 10) << type;
  }
}

TEST(DiveTask, whoDoesNotMoveSavesNone) {
  DiveTask late{TaskOptions(Options{{"reaction", "2"}}).as<DiveOptions>()};
  EXPECT_EQ(saves(late, startOf(late)), 0);
  DiveTask atTheFeet{
      TaskOptions(Options{{"reaction", "2"}, {"from", "-0.05"}, {"to", "0.05"}}).as<DiveOptions>()};
  EXPECT_GE(saves(atTheFeet, startOf(atTheFeet)), 18);
  DiveTask aside{TaskOptions(Options{{"from", "1.6"}, {"to", "2"}}).as<DiveOptions>()};
  EXPECT_EQ(saves(aside, startOf(aside)), 0) << "out of reach";
}

TEST(DiveTask, aRunDependsOnParametersAndSeedAlone) {
  DiveTask used{DiveOptions()}, fresh{DiveOptions()};
  const Eigen::VectorXd dive = startOf(used);
  used.run(dive, 8);
  expectSame(used.run(dive, 9), fresh.run(dive, 9));
}

TEST(DiveTask, tellsAMotionThatThereIsNot) {
  EXPECT_EQ(thrownBy([] {
              DiveTask task{TaskOptions(Options{{"motion", "divLeft"}}).as<DiveOptions>()};
            }),
            "option motion: no motion divLeft");
}

}  // namespace
}  // namespace plumbline::training
