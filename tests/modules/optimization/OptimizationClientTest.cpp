// A whole search behind a server is in tests/e2e/optimise_agent.sh.
#include "modules/optimization/OptimizationClient.h"

#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <thread>

#include "modules/simspark/FakeServer.h"
#include "optimization/Cmaes.h"
#include "optimization/farm/FarmServer.h"
#include "robot/RobotTypes.h"
#include "simspark/LeagueRobots.h"
#include "support/FarOff.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

class OptimizationClientTest : public testing::Test {
protected:
  OptimizationClientTest() {
    folder.write("motions/kick.yaml",
                 "ball: [0.2, -0.05]\nkick: {distance: 3}\nkeyframes:\n  - {time: 0.2, RHipPitch: -20}\n");
    robot.model = simsparkRobot(0);
    robot.name = robot.model.name;
    OptimizationClient& client = harness.module();
    client.host = "";
    client.motion = "kick";
    client.population = 4;
    client.runs = 2;
    client.generations = 1;
    client.found = folder / "found.kick.yaml";
  }
  test::ScratchFolder folder;
  test::ModuleHarness<OptimizationClient> harness{{folder.path()}};
  RobotDescription& robot = harness.input<RobotDescription>();
  OptimizationResult& result = harness.input<OptimizationResult>();
  const OptimizationTrial& trial = harness.output<OptimizationTrial>();
};

TEST_F(OptimizationClientTest, triesEachCandidateAsOftenAsItSaysAndWritesTheBest) {
  std::vector<std::vector<double>> tried;
  for (int i = 0; i < 8; ++i) {
    harness.cycle();
    ASSERT_TRUE(trial.open) << i;
    EXPECT_EQ(trial.number, i);
    EXPECT_EQ(trial.motion, "kick");
    if (i % 2 == 0)
      tried.push_back(trial.parameters);
    else
      EXPECT_EQ(trial.parameters, tried.back()) << "its second try";
    result.number = trial.number;
    result.cost = 1;
  }
  EXPECT_NE(tried[0], tried[1]);
  EXPECT_FALSE(harness.stop().requested());
  harness.cycle();
  EXPECT_TRUE(harness.stop().requested());
  EXPECT_EQ(harness.stop().exitCode(), 0);
  EXPECT_EQ(harness.stop().reason(), "the search is over; found: " + folder / "found.kick.yaml");
  const std::string found = folder.read("found.kick.yaml");
  EXPECT_NE(found.find("# Found in the agent: 1 generations, seed 1."), std::string::npos) << found;
  EXPECT_NE(found.find("ball: ["), std::string::npos) << found;
}

TEST_F(OptimizationClientTest, aResultOfAnotherTryDoesNotCount) {
  harness.cycle();
  result.number = 7;
  harness.cycle(3);
  EXPECT_EQ(trial.number, 0);
  result.number = 0;
  harness.cycle();
  EXPECT_EQ(trial.number, 1);
}

TEST_F(OptimizationClientTest, waitsForTheRobot) {
  robot.name.clear();
  harness.cycle();
  EXPECT_FALSE(trial.open);
}

TEST_F(OptimizationClientTest, aMotionOrAnOptimiserThatThereIsNotIsAnError) {
  harness.module().motion = "kik";
  EXPECT_EQ(thrownBy([&] { harness.cycle(); }),
            "OptimizationClient.motion there is no motion kik in motions/; did you mean \"kick\"?");
  harness.module().motion = "kick";
  harness.module().optimizer = "cmae";
  harness.cycle();
  EXPECT_EQ(harness.stop().exitCode(), 2);
  EXPECT_TRUE(harness.stop().reason().starts_with("unknown optimiser \"cmae\"; there are: cmaes, "))
      << harness.stop().reason();
}

TEST_F(OptimizationClientTest, aServerThatIsNotThereEndsTheAgent) {
  {
    test::FakeServer gone;
    harness.module().host = "127.0.0.1";
    harness.module().port = gone.port();
  }
  harness.cycle();
  EXPECT_EQ(harness.stop().exitCode(), 2);
  EXPECT_NE(harness.stop().reason().find(std::to_string(harness.module().port)), std::string::npos)
      << harness.stop().reason();
}

/// A server of a search of kicks, in a thread, with these options of the task.
class KickServer {
public:
  explicit KickServer(std::map<std::string, std::string> options)
      : server_(search_, nullptr, {"kick", std::move(options), 2}, {}),
        thread_([this] { server_.serve(stop_); }) {}
  ~KickServer() {
    eventfd_write(stop_, 1);
    thread_.join();
    close(stop_);
  }
  int port() const { return server_.port(); }

private:
  int stop_ = eventfd(0, EFD_CLOEXEC);
  Search search_{std::make_unique<Cmaes>(SearchSpace::around(Eigen::Vector2d(1, 2), 0.1)), {1, 1, true}, 1};
  farm::FarmServer server_;
  std::thread thread_;
};

TEST_F(OptimizationClientTest, aServersOptionsSayWhatIsTriedAndWhatItLeavesOutIsTheTasksDefault) {
  struct Case {
    std::map<std::string, std::string> options;
    std::string motion;
    Side foot;
    double distance;
  };
  for (const auto& [options, motion, foot, distance] :
       {Case{{{"motion", "kickFar"}, {"side", "left"}, {"distance", "7"}}, "kickFar", Side::left, 7},
        Case{{{"distance", "5"}}, "kickRight", Side::right, 5}}) {
    const KickServer server(options);
    test::ModuleHarness<OptimizationClient> agent{{folder.path()}};
    agent.objects().set(std::make_shared<RobotTypes>(RobotTypes{[this](int) { return robot.name; }}));
    agent.input<RobotDescription>() = robot;
    agent.module().host = "127.0.0.1";
    agent.module().port = server.port();
    const OptimizationTrial& asked = agent.output<OptimizationTrial>();
    ASSERT_TRUE(comesTrue([&] {
      agent.cycle();
      return asked.open || agent.stop().requested();
    }));
    EXPECT_EQ(agent.stop().reason(), "");
    EXPECT_EQ(asked.motion, motion);
    EXPECT_EQ(asked.foot, foot);
    EXPECT_EQ(asked.distance, distance);
  }
}

}  // namespace
}  // namespace plumbline
