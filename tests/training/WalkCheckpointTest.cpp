#include "training/WalkCheckpoint.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "training/WalkTraining.h"
#include "training/WalkingRobot.h"

namespace plumbline::training {
namespace {

class WalkCheckpointTest : public testing::Test {
protected:
  ~WalkCheckpointTest() override { std::filesystem::remove(file); }
  const std::string file =
      (std::filesystem::temp_directory_path() / ("walk" + std::to_string(getpid()) + ".search")).string();
};

WalkTrainingSetup shortSearch() {
  WalkTrainingSetup setup;
  setup.walker = [](const walking::WalkGaits& walk) { return std::make_unique<WalkingRobot>(0, walk); };
  setup.generations = 4;
  setup.population = 4;
  setup.trial.tries = 1;
  setup.trial.seconds = 2;
  setup.only = {"speed.maxForward", "step.height", "posture.torsoPitch"};
  return setup;
}

const auto silent = [](const std::string&, const walking::WalkGaits&) {};

TEST_F(WalkCheckpointTest, aWalkIsKeptBitForBit) {
  walking::WalkGaits walk = readLeagueGaits(4);
  walk.base.posture.hipHeight = 0.1 + 1e-17;
  walk.corner[2].step.height = 1.0 / 3;
  EXPECT_EQ(exactText(walkOfExactText(exactText(walk))), exactText(walk));
  EXPECT_THROW(walkOfExactText("0000"), std::invalid_argument);
  EXPECT_THROW(walkOfExactText(exactText(walk) + "nonsense 0000000000000000"), std::invalid_argument);
}

TEST_F(WalkCheckpointTest, aSearchFindsTheSameWithAnyNumberOfJobs) {
  WalkTrainingSetup setup = shortSearch();
  const std::string alone = exactText(trainWalk(readLeagueGaits(0), setup, silent));
  setup.jobs = 3;
  EXPECT_EQ(exactText(trainWalk(readLeagueGaits(0), setup, silent)), alone);
}

TEST_F(WalkCheckpointTest, aSearchThatWasInterruptedFindsTheSame) {
  WalkTrainingSetup setup = shortSearch();
  std::vector<std::string> states;
  setup.store = [&](const std::string& state) { states.push_back(state); };
  const std::string undisturbed = exactText(trainWalk(readLeagueGaits(0), setup, silent));
  ASSERT_EQ(states.size(), 4u);
  setup.store = nullptr;
  for (const std::string& state : states) {
    setup.state = state;
    EXPECT_EQ(exactText(trainWalk(readLeagueGaits(0), setup, silent)), undisturbed);
  }
}

TEST_F(WalkCheckpointTest, stagesThatAreDoneAreReadBack) {
  const walking::WalkGaits first = readLeagueGaits(1), second = readLeagueGaits(2);
  {
    WalkCheckpoint checkpoint(file, "mark");
    EXPECT_FALSE(checkpoint.resumed());
    checkpoint.stage([&] { return first; });
    EXPECT_THROW(checkpoint.stage([&]() -> walking::WalkGaits {
      checkpoint.storeSearch("state 1");
      throw std::runtime_error("killed");
    }),
                 std::runtime_error);
  }
  WalkCheckpoint checkpoint(file, "mark");
  EXPECT_TRUE(checkpoint.resumed());
  EXPECT_EQ(
      exactText(checkpoint.stage([&]() -> walking::WalkGaits { throw std::runtime_error("done before"); })),
      exactText(first));
  EXPECT_EQ(exactText(checkpoint.stage([&] { return second; })), exactText(second));
  EXPECT_EQ(checkpoint.search(), "");
  checkpoint.forget();
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(WalkCheckpointTest, whatIsOfAnotherSearchOrDamagedIsRefused) {
  WalkCheckpoint(file, "mark").stage([] { return readLeagueGaits(1); });
  const auto errorOf = [&](const std::string& mark) -> std::string {
    try {
      WalkCheckpoint checkpoint(file, mark);
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(errorOf("mark"), "no error");
  EXPECT_EQ(
      errorOf("another"),
      file +
          " is of a search with other options, another walk to begin with or another program; remove it to "
          "begin anew");
  for (const char* text :
       {"", "{", "[]", "{\"mark\": \"mark\"}", "{\"mark\": \"mark\", \"done\": [1], \"search\": \"\"}",
        "{\"mark\": \"mark\", \"done\": [], \"search\": \"0x\"}", "[[[[[[[[[[[[[[[["}) {
    std::ofstream(file) << text;
    EXPECT_EQ(errorOf("mark"), file + " is damaged; remove it to begin anew") << text;
  }
}

}  // namespace
}  // namespace plumbline::training
