// Connections that say nothing lock nobody out.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>

#include "ServerFixture.h"

namespace plumbline::simulation {
namespace {

using simspark::Connection;
using test::RunningServer;
using test::TestAgent;

std::vector<Connection> idleConnections(int port, int count) {
  std::vector<Connection> idle(static_cast<std::size_t>(count));
  for (Connection& connection : idle) EXPECT_EQ(connection.connect("127.0.0.1", port), "");
  return idle;
}

ServerConfig inRealTime() {
  ServerConfig config;
  config.simulation.seed = 3;
  return config;
}

TEST(Admission, aLatePlayerGetsInThoughIdleConnectionsFillThePort) {
  RunningServer server(inRealTime());
  TestAgent early(server.agentPort(), 0, "Early", 1);
  early.play(5);
  const auto idle = idleConnections(server.agentPort(), 200);
  TestAgent late(server.agentPort(), 0, "Late", 2);
  EXPECT_NE(late.play(5).find("(GS (unum 2)"), std::string::npos);
  const std::string still = early.play(5);
  EXPECT_EQ(still.find("gone"), std::string::npos) << "who plays keeps its place";
  EXPECT_TRUE(server.logs("sent nothing, and other clients need its place"));
  const std::string log = server.log();
  EXPECT_LT(std::count(log.begin(), log.end(), '\n'), 100);
}

TEST(Admission, whoAsksForNoRobotGoes) {
  ServerConfig config = inRealTime();
  config.agents.sceneTimeout = 0.2;
  RunningServer server(config);
  Connection idle;
  ASSERT_EQ(idle.connect("127.0.0.1", server.agentPort()), "");
  std::string_view nothing;
  EXPECT_EQ(idle.receive(nothing, 20), Connection::Status::closed);
  EXPECT_TRUE(server.logs("asked for no robot"));
}

TEST(Admission, aMonitorAndAViewerGetInToo) {
  ServerConfig config = inRealTime();
  config.field = FieldPort::Config{.port = 0};
  RunningServer server(config);
  for (const int port : {server.monitorPort(), server.fieldPort()}) {
    const auto idle = idleConnections(port, 100);
    Connection late;
    ASSERT_EQ(late.connect("127.0.0.1", port), "");
    ASSERT_TRUE(late.send("(getAck)"));
    std::string_view text;
    EXPECT_EQ(late.receive(text, farOff), Connection::Status::message) << port;
  }
}

TEST(Admission, anAgentNamesTheTokenFirst) {
  ServerConfig config = inRealTime();
  config.agents.token = "secret";
  RunningServer server(config);
  Connection good, bad;
  ASSERT_EQ(bad.connect("127.0.0.1", server.agentPort()), "");
  bad.send("(scene rsg/agent/nao/nao_hetero.rsg 0)(syn)");
  std::string_view text;
  EXPECT_EQ(bad.receive(text, farOff), Connection::Status::closed);
  EXPECT_TRUE(server.logs("did not name the token"));
  ASSERT_EQ(good.connect("127.0.0.1", server.agentPort()), "");
  good.send("(token secret)");
  good.send("(scene rsg/agent/nao/nao_hetero.rsg 0)(syn)");
  EXPECT_EQ(good.receive(text, farOff), Connection::Status::message);
}

TEST(Admission, numbersOfATrainerAreBounded) {
  RunningServer server(inRealTime());
  simspark::MonitorClient trainer;
  ASSERT_EQ(trainer.connect("127.0.0.1", server.monitorPort()), "");
  trainer.send(std::string("(ball (vel 1e308 1e308 1e308))"));
  trainer.send(std::string("(agent (unum 1)(team Left)(pos 1e300 0 0))"));
  ASSERT_EQ(trainer.receive(farOff), Connection::Status::message);
  EXPECT_TRUE(server.logs("cannot use (ball ...)"));
  for (int i = 0; i < 20; ++i) ASSERT_EQ(trainer.receive(farOff), Connection::Status::message);
}

TEST(Admission, aTrainerWithoutMeasureGoes) {
  RunningServer server(inRealTime());
  Connection trainer;
  ASSERT_EQ(trainer.connect("127.0.0.1", server.monitorPort()), "");
  std::string much;
  for (int i = 0; i < 300; ++i) much += "(dropBall)";
  trainer.send(much);
  EXPECT_TRUE(server.logs("sent too many commands in a cycle"));
}

TEST(Admission, namesOfTeamsAreShortAndPrintable) {
  for (const std::string& name : {std::string(21, 'x'), std::string("a\x1b[2J"), std::string("a\"b")}) {
    RunningServer server(inRealTime());
    TestAgent agent(server.agentPort(), 0, name, 1);
    agent.receive();
    agent.send(agent.hello);
    EXPECT_TRUE(server.logs("a team's name is 1 to 20 printable ASCII characters")) << name;
  }
}

}  // namespace
}  // namespace plumbline::simulation
