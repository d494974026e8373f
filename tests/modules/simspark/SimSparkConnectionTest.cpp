#include "modules/simspark/SimSparkConnection.h"

#include <gtest/gtest.h>

#include <thread>

#include "modules/simspark/FakeServer.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

std::shared_ptr<AgentOptions> optionsFor(const test::FakeServer& server) {
  auto options = std::make_shared<AgentOptions>();
  options->team = "Test";
  options->number = 4;
  options->type = 3;
  options->port = server.port();
  return options;
}

TEST(SimSparkConnection, asksForRobotAndPlaceAndProvidesEachMessage) {
  test::FakeServer server;
  std::string scene, init;
  std::thread side([&] {
    server.accept();
    scene = server.receive();
    server.send("(time (now 1.00))");
    init = server.receive();
    server.send("(time (now 1.02))");
    server.send("(time (now 1.04))");
  });
  test::ModuleHarness<SimSparkConnection> harness;
  harness.objects().set(optionsFor(server));
  harness.cycle();
  EXPECT_EQ(harness.output<ServerMessageText>().text, "(time (now 1.02))");
  EXPECT_EQ(harness.output<SimSparkInfo>().connections, 1);
  EXPECT_EQ(harness.output<SimSparkInfo>().cycles, 1u);
  harness.cycle();
  EXPECT_EQ(harness.output<ServerMessageText>().text, "(time (now 1.04))");
  EXPECT_EQ(harness.output<SimSparkInfo>().cycles, 2u);
  side.join();
  EXPECT_EQ(scene, "(scene rsg/agent/nao/nao_hetero.rsg 3)(syn)");
  EXPECT_EQ(init, "(init (unum 4)(teamname Test))(syn)");
}

TEST(SimSparkConnection, connectsAgainWhenTheServerWentAway) {
  test::FakeServer server;
  std::thread side([&] {
    for (const char* last : {"(time (now 9.00))", "(time (now 0.04))"}) {
      server.accept();
      server.receive();
      server.send("(time (now 0.02))");
      server.receive();
      server.send(last);
      server.drop();
    }
  });
  test::ModuleHarness<SimSparkConnection> harness;
  harness.objects().set(optionsFor(server));
  harness.cycle();
  EXPECT_EQ(harness.output<ServerMessageText>().text, "(time (now 9.00))");
  harness.cycle();
  EXPECT_EQ(harness.output<ServerMessageText>().text, "(time (now 0.04))");
  EXPECT_EQ(harness.output<SimSparkInfo>().connections, 2);
  EXPECT_FALSE(harness.stop().requested());
  side.join();
}

TEST(SimSparkConnection, namesTheTokenFirstAndSaysWhatItLost) {
  test::FakeServer server;
  std::vector<std::string> heard;
  std::thread side([&] {
    for (int i = 0; i < 2; ++i) {
      server.accept();
      heard.push_back(server.receive());
      server.receive();
      server.send("(time (now 0.02))");
      server.receive();
      server.send("(time (now 0.04))(GS (unum 4) (team left) (t 0.00) (pm BeforeKickOff))");
      server.drop();
    }
  });
  auto options = optionsFor(server);
  options->token = "secret";
  std::vector<std::string> lines;
  options->notify = [&](const std::string& line) { lines.push_back(line); };
  test::ModuleHarness<SimSparkConnection> harness;
  harness.objects().set(options);
  harness.cycle(2);
  side.join();
  EXPECT_EQ(heard, std::vector<std::string>(2, "(token secret)"));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "connection lost: the other side closed the connection; trying again");
  EXPECT_EQ(lines[1], "back on port " + std::to_string(server.port()));
}

TEST(SimSparkConnection, waitingForTheServerEndsWithTheAgent) {
  test::FakeServer server;  // never answers
  test::ModuleHarness<SimSparkConnection> harness;
  harness.objects().set(optionsFor(server));
  harness.stop().request(0, "test");
  harness.cycle();
  EXPECT_EQ(harness.output<ServerMessageText>().text, "");
}

}  // namespace
