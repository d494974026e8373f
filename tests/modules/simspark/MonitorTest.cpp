#include "modules/simspark/Monitor.h"

#include <gtest/gtest.h>

#include <thread>

#include "modules/simspark/FakeServer.h"

using namespace plumbline;
using plumbline::simspark::TeamSide;

namespace {

TEST(Monitor, sendsTrainerCommandsAndConnectsAnewWhenTheServerWentAway) {
  test::FakeServer server;
  Monitor monitor;
  monitor.setServer("127.0.0.1", server.port());
  ASSERT_TRUE(monitor.moveBall({1, 2, 0.5}, {3, 0, 0})) << monitor.error();
  server.accept();
  EXPECT_EQ(server.receive(), "(ball (pos 1.000000 2.000000 0.500000)(vel 3.000000 0.000000 0.000000))");
  ASSERT_TRUE(monitor.kickOff(TeamSide::left));
  EXPECT_EQ(server.receive(), "(kickOff Left)");
  ASSERT_TRUE(monitor.setPlayMode(simspark::PlayMode::playOn));
  EXPECT_EQ(server.receive(), "(playMode PlayOn)");
  ASSERT_TRUE(monitor.moveRobot(TeamSide::right, 3, Pose2(-1, 2, 0)));
  EXPECT_EQ(server.receive(), "(agent (unum 3)(team Right)(move -1.000000 2.000000 0.400000 -90.000000))");

  server.drop();
  ASSERT_TRUE(monitor.kickOff(TeamSide::right)) << monitor.error();
  server.accept();
  EXPECT_EQ(server.receive(), "(kickOff Right)");
}

TEST(Monitor, saysWhyACommandCouldNotBeSent) {
  int port = 0;
  {
    test::FakeServer gone;
    port = gone.port();
  }
  Monitor monitor;
  monitor.setServer("127.0.0.1", port);
  EXPECT_FALSE(monitor.kickOff(TeamSide::left));
  EXPECT_EQ(monitor.error(), "cannot connect to 127.0.0.1:" + std::to_string(port) + ": Connection refused");
}

}  // namespace
