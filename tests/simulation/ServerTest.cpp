#include "simulation/server/Server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "ServerFixture.h"
#include "math/Angle.h"

namespace plumbline::simulation {
namespace {

using simspark::AgentCommand;
using simspark::Connection;
using simspark::ServerMessage;
using test::inStep;
using test::RunningServer;
using test::TestAgent;

ServerMessage read(const std::string& text) {
  ServerMessage message;
  const auto error = simspark::parseServerMessage(text, message);
  EXPECT_FALSE(error) << text;
  return message;
}

/// A client that sends bytes of our choice.
class RawClient {
public:
  explicit RawClient(int port, int receiveBuffer = 0) : fd_(socket(AF_INET, SOCK_STREAM, 0)) {
    if (receiveBuffer > 0) setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &receiveBuffer, sizeof receiveBuffer);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~RawClient() { close(fd_); }
  void send(std::string_view bytes) {
    EXPECT_EQ(::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL), ssize_t(bytes.size()));
  }
  /// Whether the server closes the connection.
  bool isClosed() {
    char bytes[1 << 12];
    timeval patience{10, 0};
    setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    ssize_t n = 0;
    while ((n = recv(fd_, bytes, sizeof bytes, 0)) > 0) {
    }
    return n == 0 || errno == ECONNRESET;
  }

private:
  int fd_;
};

TEST(Server, anAnswerShowsInTheMessageAfterTheNext) {
  RunningServer server(inStep());
  TestAgent agent(server.agentPort(), 0, "Red", 1);
  agent.play(100);
  double angle[4];
  for (int i = 0; i < 4; ++i) {
    angle[i] = *read(agent.receive()).angle[headYaw];
    AgentCommand answer;
    answer.syn = true;
    if (i == 0) answer.velocity[headYaw] = 2;
    agent.send(answer);
  }
  EXPECT_NEAR(angle[1], angle[0], 1e-3);
  EXPECT_NEAR(angle[2] - angle[0], 0.04, 1e-3);
  EXPECT_NEAR(angle[3] - angle[0], 0.08, 1e-3);
}

TEST(Server, waitsForEveryAgentInStep) {
  RunningServer server(inStep(2));
  TestAgent first(server.agentPort(), 0, "Red", 1), second(server.agentPort(), 1, "Blue", 1);
  std::string a, b;
  for (int i = 0; i < 20; ++i) {
    a = first.play(1);
    b = second.play(1);
    EXPECT_EQ(read(a).time, read(b).time) << i;
    EXPECT_NEAR(read(a).time, 0.02 * (i + 2), 1e-9) << i;
  }
  std::string_view text;
  EXPECT_EQ(first.connection.receive(text, 0.2), Connection::Status::message);
  first.send({});  // no (syn)
  EXPECT_EQ(second.play(1).empty(), false);
  EXPECT_EQ(second.connection.receive(text, 0.3), Connection::Status::timeout);
}

TEST(Server, sameSeedSameBytesThroughTheSockets) {
  const auto game = [](std::uint64_t seed) {
    ServerConfig config = inStep(3);
    config.simulation.seed = seed;
    config.simulation.rules.kickOff.after = 0.2;
    RunningServer server(config);
    std::vector<std::unique_ptr<TestAgent>> agents;
    for (int i = 0; i < 3; ++i)
      agents.push_back(std::make_unique<TestAgent>(server.agentPort(), i, i == 1 ? "Blue" : "Red", 0));
    std::string all;
    for (int cycle = 0; cycle < 60; ++cycle)
      for (std::size_t i = 0; i < 3; ++i)
        all += agents[cycle % 2 ? i : 2 - i]->play(1);  // whoever answers first
    return all;
  };
  const std::string first = game(8);
  EXPECT_EQ(first.find("gone"), std::string::npos);
  EXPECT_EQ(first, game(8));
  EXPECT_NE(first, game(9));
}

TEST(Server, twoAndTwentyPlayWhileBadClientsAreDropped) {
  RunningServer server(inStep(22));
  std::vector<std::unique_ptr<TestAgent>> agents;
  const int types[] = {0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4};
  for (const char* team : {"Red", "Blue"})
    for (int i = 0; i < 11; ++i)
      agents.push_back(std::make_unique<TestAgent>(server.agentPort(), types[i], team, i + 1));
  const auto cycles = [&](int n) {
    for (int i = 0; i < n; ++i)
      for (auto& agent : agents) ASSERT_EQ(agent->play(1).find("gone"), std::string::npos);
  };
  // Robots appear in one spot: pull them apart at once.
  cycles(6);
  RawClient huge(server.agentPort()), garbage(server.agentPort()), word(server.agentPort());
  huge.send("\xff\xff\xff\xff");
  garbage.send(std::string_view("\0\0\0\4(a)))", 8));
  word.send(std::string_view("\0\0\0\5hello", 9));
  agents.back()->connection.close();
  agents.pop_back();
  cycles(3);
  EXPECT_TRUE(huge.isClosed());
  EXPECT_TRUE(garbage.isClosed());
  EXPECT_TRUE(word.isClosed());
  EXPECT_TRUE(server.logs("announced a message of 4294967295 bytes, at most 65536 are read"));
  EXPECT_TRUE(server.logs("sent garbage: a closing parenthesis without an opening one at byte 3"));
  EXPECT_TRUE(server.logs("sent garbage: cannot use (hello ...)"));
  EXPECT_TRUE(server.logs("(Blue 11) closed the connection"));
  cycles(3);
}

TEST(Server, halfAMessageIsDroppedAfterAWhile) {
  ServerConfig config = inStep();
  config.agents.halfTimeout = config.monitors.halfTimeout = 0.2;
  RunningServer server(config);
  RawClient agent(server.agentPort()), monitor(server.monitorPort());
  agent.send(std::string_view("\0\0\0\x20(scene", 10));
  monitor.send(std::string_view("\0\0", 2));
  TestAgent good(server.agentPort(), 0, "Red", 1);
  good.play(10);
  EXPECT_TRUE(agent.isClosed());
  EXPECT_TRUE(monitor.isClosed());
  EXPECT_TRUE(server.logs("sent half a message and no more"));
  EXPECT_EQ(good.play(10).find("gone"), std::string::npos);
}

TEST(Server, aSilentAgentIsDroppedInStep) {
  ServerConfig config = inStep(2);
  config.agents.syncTimeout = 1;
  RunningServer server(config);
  TestAgent silent(server.agentPort(), 0, "Red", 1), good(server.agentPort(), 1, "Red", 2);
  for (int i = 0; i < 10; ++i) {
    silent.play(1);
    good.play(1);
  }
  EXPECT_EQ(good.play(20).find("gone"), std::string::npos) << "it waits, then goes on";
  EXPECT_TRUE(server.logs("(Red 1) kept everybody waiting: no (syn) for 1 s"));
}

TEST(Server, anAgentThatDoesNotKnowStepsPlaysItsFirstMessages) {
  RunningServer server(inStep());
  Connection connection;
  ASSERT_EQ(connection.connect("127.0.0.1", server.agentPort()), "");
  connection.send("(scene rsg/agent/nao/nao_hetero.rsg 0)");
  std::string_view text;
  EXPECT_EQ(connection.receive(text, farOff), Connection::Status::message);
}

TEST(Server, unknownRobotsAreRefused) {
  RunningServer server(inStep());
  for (const char* scene : {"(scene rsg/agent/nao/nao_hetero.rsg 5)", "(scene rsg/agent/hoap2.rsg)"}) {
    Connection connection;
    ASSERT_EQ(connection.connect("127.0.0.1", server.agentPort()), "");
    connection.send(std::string(scene) + "(syn)");
    std::string_view text;
    EXPECT_EQ(connection.receive(text, farOff), Connection::Status::closed) << scene;
  }
  EXPECT_TRUE(
      server.logs("requested an unknown robot type: rsg/agent/nao/nao_hetero.rsg 5; there is "
                  "rsg/agent/nao/nao_hetero.rsg 0..4"));
  EXPECT_TRUE(server.logs("requested an unknown robot type: rsg/agent/hoap2.rsg 0"));
}

TEST(Server, portInUseIsSaid) {
  RunningServer server(inStep());
  ServerConfig config = inStep();
  config.agents.port = server.agentPort();
  config.monitors.port = 0;
  try {
    Server second(config, [](const std::string&) {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(),
              "port " + std::to_string(server.agentPort()) + " of 127.0.0.1 is in use; choose another or 0");
  }
}

TEST(Server, trainersCommandAndMonitorsFollow) {
  RunningServer server(inStep());
  simspark::MonitorClient monitor;
  ASSERT_EQ(monitor.connect("127.0.0.1", server.monitorPort()), "");
  ASSERT_EQ(monitor.receive(farOff), Connection::Status::message)
      << "a scene at once, though the clock stands";
  EXPECT_TRUE(monitor.scene().robots.empty());
  monitor.send(simspark::BallCommand{Vec3(3, 1, 0.042), {}});
  ASSERT_EQ(monitor.receive(farOff), Connection::Status::message);
  EXPECT_LT((monitor.scene().ball - Vec3(3, 1, 0.042)).norm(), 1e-6);

  TestAgent agent(server.agentPort(), 2, "Red", 9);
  agent.play(20);
  monitor.send(simspark::KickOffCommand{TeamSide::left});
  monitor.send("(getAck)");
  std::string mode;
  for (int i = 0; i < 500 && mode != "KickOff_Left"; ++i) mode = read(agent.play(1)).gameState.playMode;
  EXPECT_EQ(mode, "KickOff_Left");
  for (int i = 0; i < 100 && monitor.scene().playMode != "KickOff_Left"; ++i) monitor.receive(1);
  EXPECT_EQ(monitor.scene().playMode, "KickOff_Left");
  ASSERT_EQ(monitor.scene().robots.size(), 1u);
  EXPECT_EQ(monitor.scene().robots[0].unum, 9);
  EXPECT_EQ(monitor.scene().robots[0].type, 2);

  simspark::MonitorClient late;
  ASSERT_EQ(late.connect("127.0.0.1", server.monitorPort()), "");
  for (int i = 0; i < 50 && !late.scene().complete(); ++i) {
    agent.play(4);
    late.poll();
  }
  EXPECT_EQ(late.scene().robots.size(), 1u);
  EXPECT_TRUE(monitor.poll()) << "the other goes on: " << monitor.error();

  monitor.send(simspark::KillCommand{simspark::PlayerName{9, TeamSide::left}});
  EXPECT_NE(agent.play(500).find("gone"), std::string::npos);
  EXPECT_TRUE(server.logs("removed by a trainer"));
  monitor.send(simspark::KillSimulatorCommand{});
  server.join();
}

TEST(Server, whoComesWhileAnAgentIsWaitedForSeesTheScene) {
  RunningServer server(inStep(1));
  TestAgent agent(server.agentPort(), 0, "Red", 1);
  agent.play(3);
  agent.receive();  // and thinks from here on
  std::string_view scene;
  for (int i = 0; i < 2; ++i) {
    simspark::Connection monitor;
    ASSERT_EQ(monitor.connect("127.0.0.1", server.monitorPort()), "");
    ASSERT_EQ(monitor.receive(scene, 10), simspark::Connection::Status::message) << i;
    EXPECT_NE(scene.find("(RSG 0 1)"), std::string_view::npos) << scene.substr(0, 200);
  }
}

TEST(Server, aMonitorThatDoesNotReadDoesNotHoldUpThePlay) {
  ServerConfig config = inStep();
  config.monitors.interval = 1;
  config.monitors.maxQueue = 50000;
  RunningServer server(config);
  RawClient deaf(server.monitorPort(), 4096);
  TestAgent agent(server.agentPort(), 0, "Red", 1);
  // It asks for whole scenes all the time, 7 kB each, and reads none.
  std::string all;
  for (int i = 0; i < 3000 && server.log().find("does not read") == std::string::npos; ++i) {
    deaf.send(std::string_view("\0\0\0\x0e(reqfullstate)", 18));
    ASSERT_EQ(agent.play(1).find("gone"), std::string::npos);
  }
  EXPECT_TRUE(server.logs("does not read: "));
  EXPECT_TRUE(deaf.isClosed());
  EXPECT_EQ(agent.play(10).find("gone"), std::string::npos);
}

TEST(Server, monitorsNeedTheTokenIfThereIsOne) {
  ServerConfig config = inStep();
  config.monitors.token = "sesame";
  RunningServer server(config);
  simspark::MonitorClient with, without, wrong;
  ASSERT_EQ(with.connect("127.0.0.1", server.monitorPort(), "sesame"), "");
  EXPECT_EQ(with.receive(farOff), Connection::Status::message);
  ASSERT_EQ(without.connect("127.0.0.1", server.monitorPort()), "");
  EXPECT_EQ(without.receive(0.3), Connection::Status::timeout) << "tells nothing";
  without.send("(killsim)");
  EXPECT_EQ(without.receive(farOff), Connection::Status::closed);
  ASSERT_EQ(wrong.connect("127.0.0.1", server.monitorPort(), "open"), "");
  EXPECT_EQ(wrong.receive(farOff), Connection::Status::closed);
  EXPECT_TRUE(server.logs("did not name the token"));
}

TEST(Server, endsAfterItsTime) {
  ServerConfig config = inStep(0);
  config.maxSeconds = 600;  // long enough for a clock of processor time that ticks every 10 ms
  RunningServer server(config);
  server.join();
  EXPECT_EQ(server.statistics().cycles, 30'000u);
  EXPECT_NEAR(server.statistics().simulatedSeconds, 600, 1e-6);
  EXPECT_GT(server.statistics().cpuSeconds, 0);
}

TEST(Server, realTimeIsReal) {
  ServerConfig config;
  config.maxSeconds = 0.5;
  config.simulation.seed = 1;
  RunningServer server(config);
  server.join();
  EXPECT_GT(server.statistics().wallSeconds, 0.46);
}

}  // namespace
}  // namespace plumbline::simulation
