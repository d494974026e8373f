#include "web/LiveFeed.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "modules/simspark/FakeServer.h"
#include "support/FarOff.h"
#include "support/Samples.h"

namespace plumbline::web {
namespace {

struct LiveFeedTest : testing::Test {
  LiveFeedTest() {
    config.port = server.port();
    config.drawingPort = -1;
    feed = std::make_unique<LiveFeed>(config, broadcast);
    server.accept();
  }
  std::string game() const {
    const auto message = broadcast.latest(Channel::game).message;
    return message ? *message : "";
  }

  test::FakeServer server;
  Broadcast broadcast;
  LiveFeed::Config config;
  std::unique_ptr<LiveFeed> feed;
  const std::vector<std::string> messages = test::samples("monitor_two_agents");
};

TEST_F(LiveFeedTest, pagesGetAFrameForAMessageAndNoneWhileNothingComes) {
  server.send(messages[0]);
  EXPECT_TRUE(comesTrue([&] { return broadcast.latest(Channel::frame).message != nullptr; }));
  EXPECT_TRUE(comesTrue([&] { return game().find("\"AA\"") != std::string::npos; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ASSERT_EQ(broadcast.latest(Channel::frame).version, 1u);
  server.send(messages[1]);
  EXPECT_TRUE(comesTrue([&] { return broadcast.latest(Channel::frame).version == 2; }));
}

TEST_F(LiveFeedTest, aServerThatGoesIsReportedAndLookedForAgain) {
  server.send(messages[0]);
  EXPECT_TRUE(comesTrue([&] { return game().find("\"connected\":true") != std::string::npos; }));
  server.drop();
  EXPECT_TRUE(comesTrue([&] { return game().find("\"connected\":false") != std::string::npos; }));
  server.accept();
  server.send(messages[0]);
  EXPECT_TRUE(comesTrue([&] { return game().find("\"connected\":true") != std::string::npos; }));
}

}  // namespace
}  // namespace plumbline::web
