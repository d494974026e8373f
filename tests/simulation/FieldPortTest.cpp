#include "simulation/server/FieldPort.h"

#include <gtest/gtest.h>

#include "ServerFixture.h"
#include "simspark/FieldMessage.h"

namespace plumbline::simulation {
namespace {

using simspark::Connection;
using test::inStep;
using test::RunningServer;
using test::TestAgent;

ServerConfig withFieldPort(int waitForAgents = 1) {
  ServerConfig config = inStep(waitForAgents);
  config.field = FieldPort::Config{.port = 0};
  return config;
}

TEST(FieldPort, tellsTheStateAndNoMoreThanFiveTimesASecond) {
  ServerConfig config = withFieldPort();
  config.simulation.rules.kickOff.after = 0;
  RunningServer server(config);
  TestAgent agent(server.agentPort(), 0, "Red", 4);
  Connection viewer;
  ASSERT_EQ(viewer.connect("127.0.0.1", server.fieldPort()), "");
  viewer.send("(viewer 0.2)");  // what it says is not minded
  simspark::FieldState state;
  std::string_view text;
  ASSERT_EQ(viewer.receive(text, farOff), Connection::Status::message) << "at once";
  ASSERT_EQ(simspark::readFieldMessage(text, state), "") << text;
  const double start = steadySeconds();
  int messages = 0, cycles = 0;
  for (; steadySeconds() < start + 1; ++cycles) {
    agent.play(1);
    for (; viewer.receive(text, 0) == Connection::Status::message; ++messages)
      ASSERT_EQ(simspark::readFieldMessage(text, state), "") << text;
  }
  const double seconds = steadySeconds() - start;
  EXPECT_LE(messages, static_cast<int>(seconds / simspark::fieldInterval) + 1)
      << "in " << cycles << " cycles";
  EXPECT_GE(messages, 1);
  ASSERT_EQ(state.robots.size(), 1u);
  EXPECT_EQ(state.teamLeft, "Red");
  EXPECT_EQ(state.robots[0].unum, 4);
  EXPECT_EQ(state.robots[0].side, TeamSide::left);
}

TEST(FieldPort, standsAsTheGameStands) {
  RunningServer server(withFieldPort(2));  // the clock stands until two are there
  Connection viewer;
  ASSERT_EQ(viewer.connect("127.0.0.1", server.fieldPort()), "");
  std::string_view text;
  ASSERT_EQ(viewer.receive(text, farOff), Connection::Status::message);
  EXPECT_EQ(text, "(field 1)(t 0.00)(s 1 0 0)(m BeforeKickOff)(b 0 0 4)");
  EXPECT_EQ(viewer.receive(text, 0.5), Connection::Status::timeout) << "nothing changed";
}

TEST(FieldPort, asksForTheToken) {
  ServerConfig config = withFieldPort();
  config.field->token = "open";
  RunningServer server(config);
  Connection without, with;
  std::string_view text;
  ASSERT_EQ(without.connect("127.0.0.1", server.fieldPort()), "");
  ASSERT_EQ(with.connect("127.0.0.1", server.fieldPort()), "");
  EXPECT_EQ(without.receive(text, 0.3), Connection::Status::timeout);
  without.send("(token shut)");
  EXPECT_EQ(without.receive(text, farOff), Connection::Status::closed);
  EXPECT_TRUE(server.logs("did not name the token"));
  with.send("(token open)");
  EXPECT_EQ(with.receive(text, farOff), Connection::Status::message);
}

TEST(FieldPort, whatIsInUseIsAnErrorOrDoneWithout) {
  RunningServer first(withFieldPort());
  ServerConfig config = withFieldPort();
  config.field->port = first.fieldPort();
  config.agents.port = config.monitors.port = 0;
  EXPECT_THROW(Server(config, [](const std::string&) {}), std::runtime_error);
  config.fieldOptional = true;
  RunningServer second(config);
  EXPECT_EQ(second.fieldPort(), 0);
  EXPECT_TRUE(second.logs("nothing for bin/simplemonitor at its own port: port " +
                          std::to_string(first.fieldPort()) + " of 127.0.0.1 is in use"));
}

TEST(FieldPort, dropsWhoAnnouncesTooMuchAndGoesOn) {
  RunningServer server(withFieldPort());
  TestAgent agent(server.agentPort(), 0, "Red", 1);
  Connection bad;
  ASSERT_EQ(bad.connect("127.0.0.1", server.fieldPort()), "");
  bad.send(std::string(2000, 'x'));
  EXPECT_TRUE(server.logs("announced a message of 2000 bytes, at most 1024 are read"));
  EXPECT_EQ(agent.play(5).find("gone"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::simulation
