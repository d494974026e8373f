#include "pages/DebugPages.h"

#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <condition_variable>

#include "framework/DebugSite.h"
#include "support/FarOff.h"

namespace plumbline::pages {
namespace {

/// A server of the debug protocol in a thread, without a port, and one that passes a value all the time.
struct DebugPagesTest : testing::Test {
  AgentDebug agent;
  inspect::Inspector inspector{agent};
  std::unique_ptr<inspect::DebugServer> server;
  int end = eventfd(0, 0);
  std::atomic<bool> stop = false;
  std::thread serving, passing;
  std::unique_ptr<DebugPages> pages;
  std::mutex mutex;
  std::condition_variable news;
  int count = 0;

  DebugPagesTest() {
    inspect::DebugServerOptions options;
    options.listens = false;
    server = std::make_unique<inspect::DebugServer>(inspector, options);
    serving = std::thread([this] { server->serve(end); });
    passing = std::thread([this] {
      std::string value(3000, 'x');
      while (!stop) {
        MODIFY("pages:value", value);
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    });
    while (!DebugPoints::sites().find("pages:value")) std::this_thread::yield();
    pages = std::make_unique<DebugPages>(*server);
    pages->onNews([this] {
      const std::lock_guard lock(mutex);
      ++count;
      news.notify_all();
    });
  }
  void stopServer() {
    const std::uint64_t one = 1;
    EXPECT_EQ(write(end, &one, sizeof(one)), 8);
    serving.join();
    server.reset();
  }
  ~DebugPagesTest() override {
    pages.reset();
    stop = true;
    passing.join();
    if (server) stopServer();
    close(end);
  }
  /// The next message; empty where none comes.
  std::string message(PageSession& session) {
    for (;;) {
      std::unique_lock lock(mutex);
      const int before = count;
      lock.unlock();
      std::string text;
      if (session.next(text) == PageSession::Kind::text) return text;
      lock.lock();
      if (!news.wait_for(lock, std::chrono::duration<double>(farOff), [&] { return count > before; }))
        return "";
    }
  }
};

TEST_F(DebugPagesTest, aPageSpeaksTheDebugProtocol) {
  const auto page = pages->open();
  ASSERT_TRUE(page);
  EXPECT_TRUE(page->receive("format json\n#1 get nothing"));
  std::string text;
  while (!text.ends_with("#1 .")) {
    const std::string more = message(*page);
    ASSERT_NE(more, "");
    text += (text.empty() ? "" : "\n") + more;
  }
  EXPECT_EQ(text, "{\"ok\":true}\n#1 {\"error\":\"nothing is called nothing\"}\n#1 .");
}

TEST_F(DebugPagesTest, whatOnePageSetsAnotherSeesAndEnds) {
  const auto one = pages->open(), two = pages->open();
  one->receive("set pages:value \"abc\"");
  EXPECT_EQ(message(*one), "ok");
  two->receive("get pages:value");
  EXPECT_EQ(message(*two), "pages:value \"abc\"");
  two->receive("unset pages:value");
  EXPECT_EQ(message(*two), "ok");
}

TEST_F(DebugPagesTest, aPageThatDoesNotReadMissesValuesAndGetsAWord) {
  const auto page = pages->open();
  page->receive("watch pages:value");
  // 2500 values of 3 kB in half a second; a busy machine passes fewer.
  const std::string left = "lines were left out: the client reads too slowly";
  std::string text;
  for (int halfSeconds = 1; halfSeconds <= 32 && text.find(left) == std::string::npos; halfSeconds *= 2) {
    std::this_thread::sleep_for(std::chrono::milliseconds(500) * halfSeconds);
    for (int i = 0; i < 200 && text.find(left) == std::string::npos; ++i) text = message(*page);
  }
  EXPECT_NE(text.find(left), std::string::npos);
}

TEST_F(DebugPagesTest, aPageEndsWithTheServer) {
  const auto page = pages->open();
  page->receive("get pages:value");
  EXPECT_NE(message(*page), "");
  stopServer();
  std::string text;
  EXPECT_EQ(page->next(text), PageSession::Kind::end);
  EXPECT_FALSE(page->receive("get pages:value"));
}

}  // namespace
}  // namespace plumbline::pages
