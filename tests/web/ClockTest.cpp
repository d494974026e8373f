// What the embedded simulator's monitor port understands beyond the league's:
// doc/reference/trainer-extension.md.
#include <gtest/gtest.h>

#include "simulation/ServerFixture.h"

namespace plumbline::simulation {
namespace {

using simspark::ClockCommand;
using simspark::Connection;
using simspark::SimulatorClock;
using Kind = simspark::ClockCommand::Kind;
using test::RunningServer;

TEST(ClockCommands, text) {
  simspark::TrainerCommandParser parser;
  for (const char* text : {"(clock)", "(pause)", "(resume)", "(step 3)", "(speed 2.500000)",
                           "(speed 0.000000)", "(viewer 0.030000)"}) {
    std::vector<simspark::TrainerCommand> commands;
    EXPECT_EQ(parser.parse(text, commands), "") << text;
    ASSERT_EQ(commands.size(), 1u) << text;
    EXPECT_EQ(simspark::writeTrainerCommand(commands[0]), text);
  }
  for (const char* text : {"(step 0)", "(step x)", "(step 1000001)", "(speed)", "(speed -1)", "(speed 0.001)",
                           "(speed 1001)", "(viewer)", "(viewer 0)", "(viewer 61)"}) {
    std::vector<simspark::TrainerCommand> commands;
    EXPECT_NE(parser.parse(text, commands), "") << text;
    EXPECT_TRUE(commands.empty()) << text;
  }
}

TEST(ClockCommands, answer) {
  EXPECT_EQ(simspark::writeClock({true, 2.5}), "(clock (paused 1)(speed 2.5))");
  EXPECT_EQ(simspark::readClock("(clock (paused 1)(speed 2.5))"), (SimulatorClock{true, 2.5}));
  EXPECT_EQ(simspark::readClock("(clock (paused 1))"), std::nullopt);
  EXPECT_EQ(simspark::readClock("(clock"), std::nullopt);
  EXPECT_EQ(simspark::readClock("((time 1))"), std::nullopt);
}

/// A server that runs by itself as fast as it goes, and a monitor of it.
class Clock : public ::testing::Test {
protected:
  static ServerConfig config() {
    ServerConfig config = test::inStep(0);
    config.simulation.rules.kickOff.after = 0.02;
    return config;
  }
  void SetUp() override { ASSERT_EQ(monitor.connect("127.0.0.1", server.monitorPort()), ""); }
  void send(Kind kind, double value = 1) { monitor.send(ClockCommand{kind, value}); }
  /// Reads until the clock is so.
  bool becomes(const SimulatorClock& clock) {
    for (int i = 0; i < 20000 && monitor.clock() != clock; ++i)
      if (monitor.receive(5) != Connection::Status::message) return false;
    return monitor.clock() == clock;
  }
  /// Reads until nothing more comes.
  void settle() {
    while (monitor.receive(0.4) == Connection::Status::message) {
    }
  }

  RunningServer server{config()};
  simspark::MonitorClient monitor;
};

TEST_F(Clock, isSentToWhoAsks) {
  ASSERT_EQ(monitor.receive(5), Connection::Status::message);
  EXPECT_EQ(monitor.clock(), std::nullopt) << "nobody asked";
  send(Kind::subscribe);
  EXPECT_TRUE(becomes({false, 0}));
  send(Kind::speed, 4);
  EXPECT_TRUE(becomes({false, 4}));
  simspark::MonitorClient second;
  ASSERT_EQ(second.connect("127.0.0.1", server.monitorPort()), "");
  second.send(ClockCommand{Kind::pause});
  EXPECT_TRUE(becomes({true, 4})) << "whoever changed it";
}

TEST_F(Clock, standsAndSteps) {
  send(Kind::subscribe);
  monitor.send(simspark::PlayModeCommand{simspark::PlayMode::playOn});
  send(Kind::pause);
  ASSERT_TRUE(becomes({true, 0}));
  settle();
  const double time = monitor.scene().time;
  monitor.send(simspark::BallCommand{Vec3(3, 1, 0.042), Vec3::Zero()});
  ASSERT_EQ(monitor.receive(5), Connection::Status::message) << "trainers may set the scene";
  EXPECT_NEAR(monitor.scene().ball.x(), 3, 1e-6);
  EXPECT_EQ(monitor.scene().time, time);
  send(Kind::step);
  settle();
  EXPECT_NEAR(monitor.scene().time, time + 0.02, 1e-4);
  send(Kind::step, 10);
  settle();
  EXPECT_NEAR(monitor.scene().time, time + 0.22, 1e-4);
  send(Kind::resume);
  EXPECT_TRUE(becomes({false, 0}));
  for (int i = 0; i < 1000 && monitor.scene().time < time + 1; ++i) monitor.receive(5);
  EXPECT_GE(monitor.scene().time, time + 1);
}

TEST_F(Clock, aViewerGetsNoMoreThanItWants) {
  simspark::MonitorClient viewer;
  ASSERT_EQ(viewer.connect("127.0.0.1", server.monitorPort()), "");
  viewer.send(simspark::ViewerCommand{10});
  viewer.send(ClockCommand{Kind::subscribe});
  while (!viewer.clock()) ASSERT_EQ(viewer.receive(5), Connection::Status::message);
  int messages = 0;
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(monitor.receive(5), Connection::Status::message);
    if (viewer.receive(0) == Connection::Status::message) ++messages;
  }
  EXPECT_LE(messages, 1) << "the others get all messages";
  EXPECT_TRUE(viewer.connected());
}

TEST_F(Clock, aViewerSeesWhatTheOthersSee) {
  simspark::MonitorClient viewer;
  ASSERT_EQ(viewer.connect("127.0.0.1", server.monitorPort()), "");
  viewer.send(simspark::ViewerCommand{0.001});
  send(Kind::subscribe);
  send(Kind::pause);
  ASSERT_TRUE(becomes({true, 0}));
  monitor.send(simspark::BallCommand{Vec3(-4, 2, 0.042), Vec3::Zero()});
  for (int i = 0; i < 2000 && (viewer.scene().ball - Vec3(-4, 2, 0.042)).norm() > 1e-4; ++i)
    ASSERT_NE(viewer.receive(0.05), Connection::Status::closed);
  EXPECT_LT((viewer.scene().ball - Vec3(-4, 2, 0.042)).norm(), 1e-4);
}

}  // namespace
}  // namespace plumbline::simulation
