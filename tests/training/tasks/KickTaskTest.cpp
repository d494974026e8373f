#include "training/tasks/KickTask.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "framework/ConfigurationError.h"
#include "math/Angle.h"
#include "motion/KeyframeReader.h"
#include "simspark/LeagueRobots.h"
#include "support/SearchTasks.h"

namespace plumbline::training {
namespace {

using Options = std::map<std::string, std::string>;

struct TemporaryFolder {
  TemporaryFolder() : path(testing::TempDir() + "kick" + std::to_string(getpid())) {
    std::filesystem::create_directories(path);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
  std::string path;
};

TEST(KickTask, theQuickKickCarriesTheBallForward) {
  KickTask task{KickOptions()};
  double distance = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const TaskOutcome outcome = task.run(startOf(task), seed);
    distance += figure(outcome, "distance") / 4;
    EXPECT_NEAR(figure(outcome, "time"), 580, 1e-9);
    EXPECT_GT(figure(outcome, "contact"), 100);
    EXPECT_LT(figure(outcome, "contact"), 400);
  }
  EXPECT_GT(distance, 1);
  EXPECT_LT(distance, 5);
}

TEST(KickTask, aKickIsJudgedInTheWantedDirection) {
  // The same kick asked to go ahead and to the left: what was aside is along, and the direction stays.
  KickTask ahead{KickOptions()}, left{TaskOptions(Options{{"direction", "90"}}).as<KickOptions>()};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const TaskOutcome first = ahead.run(startOf(ahead), seed), other = left.run(startOf(left), seed);
    const double direction = figure(first, "direction");
    EXPECT_NEAR(figure(other, "direction"), direction, 1e-9);
    EXPECT_NEAR(figure(other, "off"), 90 - direction, 1e-9);
    EXPECT_NEAR(figure(other, "distance"), figure(first, "distance") * std::tan(fromDegrees(direction)),
                1e-9);
    EXPECT_GT(other.cost, first.cost);
  }
}

TEST(KickTask, aRunDependsOnParametersAndSeedAlone) {
  KickTask used{KickOptions()}, fresh{KickOptions()};
  const Eigen::VectorXd x = startOf(used);
  Eigen::VectorXd other = x;
  other[0] += 80;
  for (std::uint64_t seed = 20; seed < 23; ++seed) used.run(other, seed);
  const TaskOutcome first = used.run(x, 7);
  expectSame(first, fresh.run(x, 7));
  used.run(other, 7);
  expectSame(first, used.run(x, 7));
}

TEST(KickTask, aRunIsARunOfTheFile) {
  KickTask task{KickOptions()};
  Eigen::VectorXd x = startOf(task);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const TaskParameter& one = task.parameters()[static_cast<std::size_t>(i)];
    x[i] = std::clamp(x[i] + 0.37 * one.sigma * (i % 2 ? 1 : -1), one.lower, one.upper);
  }
  x[0] = 6;  // ms: the first keyframe is as good as not there
  const TemporaryFolder folder;
  const std::string path = folder.path + "/found.yaml";
  std::ofstream(path) << task.file(x, "a heading", {});
  const motion::KeyframeMotion read = motion::readKeyframeFile(path, simsparkRobot(0), {});
  EXPECT_EQ(read.keyframes.size(), task.first().keyframes.size() - 1);
  EXPECT_FALSE(read.kick);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) expectSame(task.tryMotion(read, seed), task.run(x, seed));

  std::ofstream(path) << task.file(x, "",
                                   {{"distance", 9.87},
                                    {"direction", -3},
                                    {"contact", 240},
                                    {"height", 0.75},
                                    {"direction.deviation", 4.5},
                                    {"distance.deviation", 1.25}});
  const auto kick = motion::readKeyframeFile(path, simsparkRobot(0), {}).kick;
  ASSERT_TRUE(kick);
  EXPECT_DOUBLE_EQ(kick->distance, 9.87);
  EXPECT_NEAR(kick->direction, -3 * pi / 180, 1e-12);
  EXPECT_DOUBLE_EQ(kick->contact, 0.24);
  EXPECT_NEAR(kick->scatter, 4.5 * pi / 180, 1e-12);
  EXPECT_DOUBLE_EQ(kick->spread, 1.25);
  EXPECT_DOUBLE_EQ(kick->rise, 0.75);
}

TEST(KickTask, aKickThatGoesPastBackwardHasADirectionThatAFileMayHave) {
  const KickTask task{KickOptions()};
  const std::string file = task.file(startOf(task), "",
                                     {{"distance", 2},
                                      {"direction", 190},
                                      {"contact", 240},
                                      {"height", 0},
                                      {"direction.deviation", 4.5},
                                      {"distance.deviation", 1}});
  EXPECT_NE(file.find("direction: -170"), std::string::npos) << file;
}

TEST(KickTask, aWantedDistanceIsBetterThanAFartherKick) {
  KickTask farthest(TaskOptions(Options{{"steady", "0"}, {"weight", "0"}}).as<KickOptions>());
  KickTask wanted(
      TaskOptions(Options{{"steady", "0"}, {"weight", "0"}, {"distance", "1"}}).as<KickOptions>());
  const TaskOutcome far = farthest.run(startOf(farthest), 3), near = wanted.run(startOf(wanted), 3);
  const double along = figure(far, "distance"), aside = along * std::tan(figure(far, "off") * pi / 180);
  EXPECT_NEAR(far.cost, -30 * (along - aside) - 120 * figure(far, "height"), 1e-6);
  EXPECT_NEAR(near.cost, 30 * (std::abs(along - 1) + aside), 1e-6);
}

/// The ball goes the same way; what follows is another.
TEST(KickTask, standsStillAfterwardsInTheShareOfRunsThatIsAskedFor) {
  KickTask walks{KickOptions()}, stands(TaskOptions(Options{{"still", "1"}}).as<KickOptions>()),
      some(TaskOptions(Options{{"still", "0.5"}}).as<KickOptions>());
  int stood = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const TaskOutcome walked = walks.run(startOf(walks), seed), still = stands.run(startOf(stands), seed);
    EXPECT_EQ(figure(walked, "contact"), figure(still, "contact"));
    EXPECT_NE(walked.cost, still.cost);
    const double cost = some.run(startOf(some), seed).cost;
    EXPECT_TRUE(cost == walked.cost || cost == still.cost);
    stood += cost == still.cost;
  }
  EXPECT_GT(stood, 0);
  EXPECT_LT(stood, 8);
}

/// type 2's long kick flies over a goal more often than not, its quick kick never.
TEST(KickTask, tellsHowHighTheBallIsWhereAGoalMayStand) {
  KickTask high(TaskOptions(Options{{"type", "2"}, {"motion", "kickLong"}}).as<KickOptions>());
  KickTask quick(TaskOptions(Options{{"type", "2"}}).as<KickOptions>());
  KickTask shot(
      TaskOptions(Options{{"type", "2"}, {"motion", "kickLong"}, {"ceiling", "0.3"}}).as<KickOptions>());
  int over = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const TaskOutcome far = high.run(startOf(high), seed), low = quick.run(startOf(quick), seed);
    over += figure(far, "low") == 0;
    const bool came = figure(far, "distance") > 3;  // a ball that is hardly met is not low, but short
    EXPECT_EQ(figure(far, "low") == 1, came && figure(far, "top") < 0.8);
    EXPECT_LE(figure(far, "top"), figure(far, "height") + 2 * 0.042 + 1e-3);
    EXPECT_EQ(figure(low, "low"), 1);
    const TaskOutcome dear = shot.run(startOf(shot), seed);
    const double above = figure(far, "top") - 0.3;
    EXPECT_NEAR(dear.cost - far.cost,
                120 * std::min(1.0, figure(far, "height")) + (above > 0 ? 60 + 300 * above : 0), 1e-6);
  }
  EXPECT_GE(over, 1);
}

TEST(KickTask, theLeftFootKicksAsTheRightOne) {
  KickTask left(TaskOptions(Options{{"side", "left"}}).as<KickOptions>());
  EXPECT_GT(left.parameters().back().start, 0) << "ballY";
  double distance = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    distance += figure(left.run(startOf(left), seed), "distance") / 4;
  EXPECT_GT(distance, 1);
}

std::string errorOf(const Options& options) {
  try {
    KickTask task{TaskOptions(options).as<KickOptions>()};
    return "no error";
  } catch (const ConfigurationError& error) {
    return error.what();
  }
}

TEST(KickTask, badOptionsAreReported) {
  EXPECT_EQ(errorOf({{"motion", "wave"}}), "option motion: wave is no kick: it has no ball");
  EXPECT_EQ(errorOf({{"motion", "kick"}}), "option motion: no motion kick");
  EXPECT_EQ(errorOf({{"distanse", "3"}}), "unknown option \"distanse\"; did you mean \"distance\"?");
  EXPECT_EQ(errorOf({{"side", "middle"}}), "option side: \"middle\" is not one of right, left");
}

}  // namespace
}  // namespace plumbline::training
