#include "training/tasks/PositioningTask.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "support/SearchTasks.h"
#include "support/Thrown.h"

namespace plumbline::training {
namespace {

Eigen::Index indexOf(const SearchTask& task, const std::string& name) {
  for (std::size_t i = 0; i < task.parameters().size(); ++i)
    if (task.parameters()[i].name == name) return static_cast<Eigen::Index>(i);
  ADD_FAILURE() << "no parameter " << name;
  return 0;
}

PositioningOptions type(const char* number) {
  return TaskOptions(std::map<std::string, std::string>{{"type", number}}).as<PositioningOptions>();
}

TEST(PositioningTask, theRobotGoesToTheBallAndKicksItFar) {
  PositioningTask task(type("4"));
  const Eigen::VectorXd start = startOf(task);
  double time = 0, distance = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TaskOutcome outcome = task.run(start, seed);
    EXPECT_EQ(figure(outcome, "kicked"), 1) << seed;
    EXPECT_EQ(figure(outcome, "fell"), 0) << seed;
    EXPECT_GE(figure(outcome, "time"), figure(outcome, "there"));
    time += figure(outcome, "time") / 5;
    distance += figure(outcome, "distance") / 5;
  }
  EXPECT_GT(time, 2);
  EXPECT_LT(time, 8);
  EXPECT_GT(distance, 7);
}

TEST(PositioningTask, aRunDependsOnParametersAndSeedAlone) {
  PositioningTask used(type("4")), fresh(type("4"));
  const Eigen::VectorXd start = startOf(used);
  used.run(start, 8);
  const TaskOutcome a = used.run(start, 9);
  expectSame(a, fresh.run(start, 9));
  EXPECT_NE(a.cost, used.run(start, 10).cost);
}

TEST(PositioningTask, startsAreDrawnUpToTheFarthest) {
  PositioningTask near(type("3")),
      far(TaskOptions(std::map<std::string, std::string>{{"type", "3"}, {"start", "7"}, {"farthest", "9"}})
              .as<PositioningOptions>());
  const Eigen::VectorXd start = startOf(near);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    // At 0.5 m/s at least, on more than 5 m more.
    EXPECT_GT(figure(far.run(start, seed), "time"), figure(near.run(start, seed), "time") + 2) << seed;
    EXPECT_LT(figure(far.run(start, seed), "time"), 24) << seed;
  }
}

TEST(PositioningTask, whoNeverStandsExactlyEnoughNeverKicks) {
  PositioningTask task(type("4"));
  Eigen::VectorXd parameters = startOf(task);
  parameters[indexOf(task, "toleranceForward")] = parameters[indexOf(task, "toleranceSideways")] = 0.001;
  parameters[indexOf(task, "toleranceHeading")] = 0.001;
  const TaskOutcome outcome = task.run(parameters, 1);
  EXPECT_EQ(figure(outcome, "kicked"), 0);
  EXPECT_EQ(figure(outcome, "time"), 20);
  EXPECT_GT(outcome.cost, 25) << "half a second for each metre of the kick";
}

TEST(PositioningTask, theFileHasWhatWasSearchedAndIsReadAsAnOverlay) {
  PositioningTask task(type("4"));
  Eigen::VectorXd parameters = startOf(task);
  parameters[indexOf(task, "walk_maxTurn")] = 2.123456;
  const std::string file = task.file(parameters, "Found.\nBy a test.", {});
  EXPECT_EQ(file.substr(0, 21), "# Found.\n# By a test.");
  EXPECT_NE(file.find("\noverlay: {base: SkillGetBall.yaml, values: " +
                      std::to_string(task.parameters().size()) + "}\npositioning:\n  walk:\n"),
            std::string::npos)
      << file;
  EXPECT_NE(file.find("\n    maxTurn: 2.123\n"), std::string::npos) << file;
  EXPECT_NE(file.find("\n  leaveTolerances: "), std::string::npos) << file;
  Eigen::VectorXd rounded = parameters;
  rounded[indexOf(task, "walk_maxTurn")] = 2.123;
  EXPECT_EQ(task.run(parameters, 3).cost, task.run(rounded, 3).cost);
}

TEST(PositioningTask, aPartOfTheNumbersIsSearchedAndAllAreWritten) {
  const auto searching = [](const char* part) {
    return PositioningTask(TaskOptions(std::map<std::string, std::string>{{"type", "4"}, {"searched", part}})
                               .as<PositioningOptions>());
  };
  PositioningTask all(type("4")), near = searching("near"), far = searching("far");
  EXPECT_EQ(near.parameters().size() + far.parameters().size(), all.parameters().size());
  EXPECT_EQ(near.parameters()[0].name.substr(0, 5), "plan_");
  EXPECT_EQ(far.parameters()[0].name.substr(0, 5), "walk_");
  const auto body = [](const PositioningTask& task) { return task.file(startOf(task), "Found.", {}); };
  EXPECT_EQ(body(near), body(all));
  EXPECT_EQ(near.run(startOf(near), 5).cost, all.run(startOf(all), 5).cost);
}

TEST(PositioningTask, tellsOptionsThatItCannotUse) {
  const auto with = [](const char* key, const char* value) {
    return thrownBy([&] {
      PositioningTask task{
          TaskOptions(std::map<std::string, std::string>{{key, value}}).as<PositioningOptions>()};
    });
  };
  EXPECT_EQ(with("motion", "wave"), "option motion: wave is no kick of this robot");
  EXPECT_EQ(with("searched", "nearby"), "option searched: \"nearby\" is not one of all, far, near, place");
  EXPECT_EQ(with("start", "0.1"), "option start: \"0.1\" is no number from 0.3 to 10");
}

TEST(PositioningTask, aKicksPlaceIsSearchedAndItsFileWritten) {
  PositioningTask task(
      TaskOptions(std::map<std::string, std::string>{
                      {"type", "1"}, {"searched", "place"}, {"start", "0.5"}, {"metre", "1"}})
          .as<PositioningOptions>());
  const Eigen::VectorXd start = startOf(task);
  ASSERT_EQ(start.size(), 3);
  Eigen::VectorXd tooFar = start;
  tooFar[0] += 35;
  double near = 0, far = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    near += figure(task.run(start, seed), "distance");
    far += figure(task.run(tooFar, seed), "distance");
  }
  EXPECT_GT(near, far + 4) << "a ball 35 mm farther ahead is hardly met";
  tooFar[2] = -4.5;
  const std::string file = task.file(tooFar, "Found.", {});
  EXPECT_EQ(file.substr(0, 9), "# Found.\n");
  EXPECT_NE(file.find("direction: -4.50"), std::string::npos) << file;
  EXPECT_NE(file.find("\nkeyframes:\n"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::training
