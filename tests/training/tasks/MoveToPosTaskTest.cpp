#include "training/tasks/MoveToPosTask.h"

#include <gtest/gtest.h>

#include <string>

#include "support/SearchTasks.h"
#include "support/Thrown.h"

namespace plumbline::training {
namespace {

MoveToPosOptions options(std::map<std::string, std::string> values) {
  return TaskOptions(std::move(values)).as<MoveToPosOptions>();
}

TEST(MoveToPosTask, everyTypeWalksToThePlaceAndStops) {
  MoveToPosTask task(options({{"nearest", "3"}, {"farthest", "3"}}));
  const Eigen::VectorXd start = startOf(task);
  for (std::uint64_t seed = 5; seed < 10; ++seed) {  // types 0 to 4
    const TaskOutcome outcome = task.run(start, seed);
    EXPECT_EQ(figure(outcome, "fell"), 0) << seed;
    EXPECT_NEAR(figure(outcome, "metres"), 3, 1e-9);
    EXPECT_GT(figure(outcome, "time"), 3) << "faster than 1 m/s, with turns: type " << seed % 5;
    EXPECT_LT(figure(outcome, "time"), 10) << "type " << seed % 5;
    EXPECT_EQ(outcome.cost, figure(outcome, "time"));
  }
}

TEST(MoveToPosTask, aRunDependsOnParametersAndSeedAlone) {
  MoveToPosTask used(options({})), fresh(options({}));
  const Eigen::VectorXd start = startOf(used);
  used.run(start, 13);
  const TaskOutcome a = used.run(start, 8);
  expectSame(a, fresh.run(start, 8));
  EXPECT_NE(a.cost, used.run(start, 18).cost) << "the same type from another place";
}

TEST(MoveToPosTask, aRobotThatHardlyWalksNeedsAllTheTimeThereIs) {
  MoveToPosTask task(options({{"nearest", "9"}, {"farthest", "9"}, {"type", "3"}}));
  Eigen::VectorXd parameters = startOf(task);
  for (Eigen::Index i = 0; i < parameters.size(); ++i)
    if (const std::string& name = task.parameters()[static_cast<std::size_t>(i)].name;
        name == "maxForward" || name == "curveSpeed" || name == "maxSideways" || name == "maxBackward")
      parameters[i] = 0.05;
  EXPECT_NEAR(figure(task.run(parameters, 1), "time"), 40, 0.03);
}

TEST(MoveToPosTask, theFileIsThatOfTheSkill) {
  MoveToPosTask task(options({{"type", "0"}}));
  Eigen::VectorXd parameters = startOf(task);
  parameters[0] = 1.23456;
  EXPECT_EQ(task.parameters()[0].name, "maxForward");
  const std::string file = task.file(parameters, "Found.", {});
  EXPECT_EQ(file.substr(0, 36), "# Found.\nwalk:\n  maxForward: 1.235\n ") << file;
}

TEST(MoveToPosTask, tellsOptionsThatItCannotUse) {
  EXPECT_EQ(thrownBy([] {
              MoveToPosTask task(options({{"farthest", "100"}}));
            }),
            "option farthest: \"100\" is no number from 0.1 to 12");
  EXPECT_EQ(thrownBy([] {
              MoveToPosTask task(options({{"typ", "1"}}));
            }),
            "unknown option \"typ\"; did you mean \"type\"?");
}

}  // namespace
}  // namespace plumbline::training
