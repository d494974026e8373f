#include "modules/infrastructure/DebugModule.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

#include "framework/DrawingSite.h"
#include "support/ModuleHarness.h"
#include "support/Thrown.h"
#include "support/ViewerPort.h"

namespace plumbline {
namespace {

class DebugModuleTest : public testing::Test {
protected:
  DebugModuleTest() {
    options->server.port = 0;
    options->notify = [this](const std::string& line) { lines.push_back(line); };
  }
  /// What the server answers to a client within the program.
  static std::string ask(inspect::DebugServer& server, const std::string& command) {
    const int socket = server.join();
    std::string answer;
    if (write(socket, command.data(), command.size()) == static_cast<ssize_t>(command.size())) {
      pollfd ready{socket, POLLIN, 0};
      char buffer[4096];
      if (poll(&ready, 1, 10000) > 0)
        answer.assign(buffer,
                      static_cast<std::size_t>(std::max<ssize_t>(0, read(socket, buffer, sizeof buffer))));
    }
    close(socket);
    return answer;
  }
  std::shared_ptr<DebugOptions> options = std::make_shared<DebugOptions>();
  std::shared_ptr<AgentDebug> agent = std::make_shared<AgentDebug>();
  std::vector<std::string> lines;
};

TEST_F(DebugModuleTest, opensThePortTellsItAndAnswersInAThreadOfItsOwn) {
  inspect::DebugServer* served = nullptr;
  options->serve = [&](inspect::DebugServer& server) {
    served = &server;
    return std::shared_ptr<void>();
  };
  test::ModuleHarness<DebugModule> harness;
  harness.objects().set(options);
  harness.objects().set(agent);
  harness.cycle();
  ASSERT_TRUE(served);
  const std::string address = "127.0.0.1:" + std::to_string(served->port());
  EXPECT_EQ(lines, std::vector<std::string>{"debug port " + address + ": bin/rdb " + address});
  EXPECT_EQ(ask(*served, "gte x\n"), "error: no command \"gte\"; did you mean \"get\"? (help lists them)\n");
}

TEST_F(DebugModuleTest, withoutAPortOnlyWhatItServesJoins) {
  options->server.listens = false;
  std::string answer;
  options->serve = [&](inspect::DebugServer& server) {
    EXPECT_EQ(server.port(), 0);
    return std::shared_ptr<void>();
  };
  test::ModuleHarness<DebugModule> harness;
  harness.objects().set(options);
  harness.objects().set(agent);
  harness.cycle();
  EXPECT_TRUE(lines.empty());
}

TEST_F(DebugModuleTest, withoutOptionsOrAnAgentThereIsNoPort) {
  test::ModuleHarness<DebugModule> none;
  none.objects().set(agent);
  none.cycle();
  test::ModuleHarness<DebugModule> alone;
  alone.objects().set(options);
  alone.cycle();
  EXPECT_TRUE(lines.empty());
}

TEST_F(DebugModuleTest, drawingsThatTheCommandLineNamesAreOnFromTheirFirstCycle) {
  test::ViewerPort viewer;
  options->server.listens = false;
  options->viewer.port = viewer.port;
  options->drawings = {"draw:DebugModuleTest:early"};
  test::ModuleHarness<DebugModule> harness;
  harness.objects().set(options);
  harness.objects().set(agent);
  harness.cycle();
  EXPECT_TRUE(agent->watched()) << "the threads serve what is asked of them";
  int drawn = 0;
  DEBUG_DRAWING("draw:DebugModuleTest:early", ++drawn; drawing.point(Vec2(1, 2), {10, 20, 30}, 5));
  EXPECT_EQ(drawn, 1) << "the point's first passage";
  EXPECT_NE(viewer.received().find("left.00.DebugModuleTest:early."), std::string::npos);
}

TEST_F(DebugModuleTest, whatItServesEndsBeforeTheServer) {
  bool ended = false;
  options->serve = [&](inspect::DebugServer& server) {
    return std::shared_ptr<void>(&server, [&](void*) { ended = server.join() >= 0; });
  };
  {
    test::ModuleHarness<DebugModule> harness;
    harness.objects().set(options);
    harness.objects().set(agent);
    harness.cycle();
    EXPECT_FALSE(ended);
  }
  EXPECT_TRUE(ended);
}

TEST_F(DebugModuleTest, anAddressThatCannotBeIsOneLine) {
  options->server.address = "everywhere";
  test::ModuleHarness<DebugModule> harness;
  harness.objects().set(options);
  harness.objects().set(agent);
  const std::string error = thrownBy([&] { harness.module(); });
  EXPECT_NE(error.find("everywhere"), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace plumbline
