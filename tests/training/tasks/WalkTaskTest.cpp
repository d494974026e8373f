#include "training/tasks/WalkTask.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "training/WalkingRobot.h"

namespace plumbline::training {
namespace {

using Options = std::map<std::string, std::string>;

Eigen::VectorXd walkStart(const SearchTask& task) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(task.parameters().size()));
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = task.parameters()[static_cast<std::size_t>(i)].start;
  return x;
}

TEST(WalkTask, theStartIsTheTypesWalk) {
  WalkTask task(TaskOptions(Options{{"type", "3"}, {"seconds", "4"}}).as<WalkOptions>());
  const TaskOutcome outcome = task.run(walkStart(task), 1);
  WalkingRobot robot(3);
  const WalkTrialSetup trial{.seed = 1, .tries = 1, .seconds = 4, .alsoCut = true};
  const WalkTrialResult wanted = tryWalk(robot, readLeagueGaits(3), WalkTrialKind::forward, trial);
  EXPECT_EQ(outcome.cost, walkCost(WalkTrialKind::forward, wanted));
  EXPECT_EQ(outcome.figures[0], (std::pair<std::string, double>("speed", wanted.speed)));
  EXPECT_GT(wanted.speed, 0.3);
}

TEST(WalkTask, aRunDependsOnParametersAndSeedAlone) {
  const Options options{{"direction", "sideways"}, {"seconds", "3"}};
  WalkTask used{TaskOptions(options).as<WalkOptions>()}, fresh{TaskOptions(options).as<WalkOptions>()};
  const Eigen::VectorXd x = walkStart(used);
  Eigen::VectorXd other = x;
  other[0] += used.parameters()[0].sigma;
  used.run(other, 3);
  const TaskOutcome first = used.run(x, 7);
  EXPECT_EQ(first.cost, fresh.run(x, 7).cost);
  EXPECT_NE(first.cost, fresh.run(other, 7).cost);
}

TEST(WalkTask, itsFileIsTheWalkOfTheParameters) {
  WalkTask task(TaskOptions(Options{{"type", "1"}, {"direction", "turn"}}).as<WalkOptions>());
  Eigen::VectorXd x = walkStart(task);
  const TaskParameter& one = task.parameters()[0];
  EXPECT_EQ(one.name, "turn_posture_hipHeight");
  x[0] = one.start + one.sigma;
  const std::string folder = testing::TempDir() + "walkTask";
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/walking.yaml") << task.file(x, "Found.\nBy a test.", {});
  const ConfigFile file("walking", {configFolder(), folder});
  const walking::WalkGaits read = walking::readWalkGaits(file.root());
  const WalkVariable variable = variablesOf(WalkTrialKind::turn)[0];
  EXPECT_NEAR(valueOf(read, variable), x[0], 1e-4);
  std::filesystem::remove_all(folder);
}

std::string walkError(const Options& options) {
  try {
    WalkTask task{TaskOptions(options).as<WalkOptions>()};
    return "no error";
  } catch (const ConfigurationError& error) {
    return error.what();
  }
}

TEST(WalkTask, badOptionsAreReported) {
  EXPECT_EQ(walkError({{"direction", "up"}}),
            "option direction: \"up\" is not one of forward, backward, sideways, turn, mixture, push");
  EXPECT_EQ(walkError({{"tipe", "3"}}), "unknown option \"tipe\"; did you mean \"type\"?");
}

}  // namespace
}  // namespace plumbline::training
