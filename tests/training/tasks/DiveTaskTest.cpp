#include "training/tasks/DiveTask.h"

#include <gtest/gtest.h>

#include "support/SearchTasks.h"
#include "support/Thrown.h"

namespace plumbline::training {
namespace {

using DiveOptions = std::map<std::string, std::string>;

/// Of 20 shots the number of saves.
int saves(DiveTask& task, const Eigen::VectorXd& parameters) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) count += figure(task.run(parameters, seed), "saved") > 0;
  return count;
}

TEST(DiveTask, theDiveSavesMostShotsInItsReach) {
  for (const char* type : {"0", "4"}) {
    DiveTask task{TaskOptions(DiveOptions{{"type", type}})};
    EXPECT_GE(saves(task, startOf(task)), 10) << type;
  }
}

TEST(DiveTask, whoDoesNotMoveSavesNone) {
  DiveTask late{TaskOptions(DiveOptions{{"reaction", "2"}})};
  EXPECT_EQ(saves(late, startOf(late)), 0);
  DiveTask atTheFeet{TaskOptions(DiveOptions{{"reaction", "2"}, {"from", "-0.05"}, {"to", "0.05"}})};
  EXPECT_GE(saves(atTheFeet, startOf(atTheFeet)), 18);
  DiveTask aside{TaskOptions(DiveOptions{{"from", "1.6"}, {"to", "2"}})};
  EXPECT_EQ(saves(aside, startOf(aside)), 0) << "out of reach";
}

TEST(DiveTask, aRunDependsOnParametersAndSeedAlone) {
  DiveTask used{TaskOptions()}, fresh{TaskOptions()};
  const Eigen::VectorXd dive = startOf(used);
  used.run(dive, 8);
  expectSame(used.run(dive, 9), fresh.run(dive, 9));
}

TEST(DiveTask, tellsAMotionThatThereIsNot) {
  EXPECT_EQ(thrownBy([] {
              DiveTask task{TaskOptions(DiveOptions{{"motion", "divLeft"}})};
            }),
            "option motion: no motion divLeft");
}

}  // namespace
}  // namespace plumbline::training
