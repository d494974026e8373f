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
    EXPECT_EQ(trial.task, "kick");
    EXPECT_EQ(trial.options, std::vector<std::string>{"motion=kick"});
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
    harness.module().patience = 0;
  }
  harness.cycle();
  EXPECT_EQ(harness.stop().exitCode(), 2);
  EXPECT_NE(harness.stop().reason().find(std::to_string(harness.module().port)), std::string::npos)
      << harness.stop().reason();
}

/// A server of a search of kicks, in a thread, with these options of the task.
class KickServer {
public:
  explicit KickServer(std::map<std::string, std::string> options = {}, int port = 0)
      : server_(search_, nullptr, {"kick", std::move(options), 2}, at(port)),
        thread_([this] { server_.serve(stop_); }) {}
  ~KickServer() {
    eventfd_write(stop_, 1);
    thread_.join();
    close(stop_);
  }
  int port() const { return server_.port(); }

private:
  static farm::FarmOptions at(int port) {
    farm::FarmOptions options;
    options.port = port;
    return options;
  }

  int stop_ = eventfd(0, EFD_CLOEXEC);
  Search search_{std::make_unique<Cmaes>(SearchSpace::around(Eigen::Vector2d(1, 2), 0.1)), {1, 1, true}, 1};
  farm::FarmServer server_;
  std::thread thread_;
};

class OptimizationClientOfServerTest : public OptimizationClientTest {
protected:
  OptimizationClientOfServerTest() {
    harness.objects().set(std::make_shared<RobotTypes>(RobotTypes{[](int) { return simsparkRobotName(0); }}));
    harness.module().host = "127.0.0.1";
  }
  /// What the server learns of only if it is there.
  void endTry() { result.number = trial.number; }
  /// A try is open, or the agent stops.
  bool tries() {
    return comesTrue([&] {
      harness.cycle();
      return trial.open || harness.stop().requested();
    });
  }
};

TEST_F(OptimizationClientOfServerTest, theServersOptionsAreTheTrials) {
  const KickServer server({{"motion", "kickFar"}, {"side", "left"}, {"direction", "30"}});
  harness.module().port = server.port();
  ASSERT_TRUE(tries());
  EXPECT_EQ(harness.stop().reason(), "");
  EXPECT_EQ(trial.task, "kick");
  EXPECT_EQ(trial.options, (std::vector<std::string>{"direction=30", "motion=kickFar", "side=left"}));
}

TEST_F(OptimizationClientOfServerTest, whatAnAgentCannotTryIsRefused) {
  const KickServer server(std::map<std::string, std::string>{{"engine", "bullet"}});
  harness.module().port = server.port();
  EXPECT_EQ(thrownBy([&] { tries(); }),
            "the server's task kick has the option engine; an agent cannot try that, bin/optworker can");
}

TEST_F(OptimizationClientOfServerTest, aServerThatGoesAwayIsWaitedFor) {
  int port = 0;
  {
    const KickServer server;
    harness.module().port = port = server.port();
    ASSERT_TRUE(tries());
  }
  endTry();
  ASSERT_TRUE(comesTrue([&] {
    harness.cycle();
    return !trial.open;
  }));
  harness.cycle(3);
  EXPECT_FALSE(harness.stop().requested()) << harness.stop().reason();
  const std::int64_t lost = result.number;
  const KickServer again({{"direction", "30"}}, port);
  ASSERT_TRUE(tries());
  EXPECT_FALSE(harness.stop().requested()) << harness.stop().reason();
  EXPECT_GT(trial.number, lost);
  EXPECT_EQ(trial.options, std::vector<std::string>{"direction=30"});
}

TEST_F(OptimizationClientOfServerTest, itWaitsForPatienceAlone) {
  {
    const KickServer server;
    harness.module().port = server.port();
    ASSERT_TRUE(tries());
  }
  endTry();
  harness.module().patience = 0.3;
  ASSERT_TRUE(comesTrue([&] {
    harness.cycle();
    return harness.stop().requested();
  }));
  EXPECT_EQ(harness.stop().exitCode(), 2);
  EXPECT_NE(harness.stop().reason().find("127.0.0.1:"), std::string::npos) << harness.stop().reason();
}

}  // namespace
}  // namespace plumbline
