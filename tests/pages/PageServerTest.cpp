#include "pages/PageServer.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <list>

#include "support/FarOff.h"
#include "support/ScratchFolder.h"

namespace plumbline::pages {
namespace {

/// A silent connection is closed after ten seconds anyway; an idle machine needs a few milliseconds [ms].
constexpr int soon = 5000;

/// A browser, by hand.
class Visitor {
public:
  explicit Visitor(int port) : fd_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~Visitor() { close(fd_); }
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;

  void say(const std::string& text) const {
    EXPECT_EQ(send(fd_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  /// The first line of what comes in time; "closed" or "silence" if nothing does.
  std::string line(int milliseconds) const {
    pollfd ready{fd_, POLLIN, 0};
    if (poll(&ready, 1, milliseconds) <= 0) return "silence";
    char buffer[1024];
    const ssize_t got = recv(fd_, buffer, sizeof buffer, 0);
    if (got <= 0) return "closed";
    const std::string text(buffer, static_cast<std::size_t>(got));
    return text.substr(0, text.find('\r'));
  }

private:
  int fd_;
};

class NoPages : public PageSource {
public:
  std::unique_ptr<PageSession> open() override { return nullptr; }
  std::size_t maxMessage() const override { return 1000; }
  void onNews(std::function<void()>) override {}
};

struct PageServerTest : testing::Test {
  PageServerTest() {
    folder.write("index.html", "<html>a page</html>");
    open();
    server->start();
  }
  void open() {
    PageServer::Config config;
    config.port = 0;
    config.folder = folder.path();
    server = std::make_unique<PageServer>(config, source);
  }
  /// The status of a visit now.
  std::string visit(const std::string& path = "/") const {
    const Visitor late(server->port());
    late.say("GET " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    return late.line(soon);
  }
  test::ScratchFolder folder;
  NoPages source;
  std::unique_ptr<PageServer> server;
};

TEST_F(PageServerTest, servesItsFolder) {
  EXPECT_EQ(visit(), "HTTP/1.1 200 OK");
  EXPECT_EQ(visit("/none").substr(0, 12), "HTTP/1.1 404");
}

TEST_F(PageServerTest, silentConnectionsGiveWay) {
  std::list<Visitor> silent;
  for (int i = 0; i < 400; ++i) silent.emplace_back(server->port());
  EXPECT_EQ(visit(), "HTTP/1.1 200 OK");
  EXPECT_EQ(silent.front().line(farOff * 1000), "closed") << "it was silent longest";
  EXPECT_EQ(silent.back().line(0), "silence");
}

TEST_F(PageServerTest, halfARequestGivesWayToo) {
  std::list<Visitor> slow;
  for (int i = 0; i < 400; ++i) slow.emplace_back(server->port()).say("GET / HTTP/1.1\r\nHost: loc");
  EXPECT_EQ(visit(), "HTTP/1.1 200 OK");
}

TEST_F(PageServerTest, halfRequestsThatComeAllAtOnceGiveWayToo) {
  // They are there before the server runs, so of each one something is to be read when it is taken in.
  open();
  std::list<Visitor> slow;
  for (int i = 0; i < 300; ++i) slow.emplace_back(server->port()).say("GET / HTTP/1.1\r\nHost: loc");
  server->start();
  EXPECT_EQ(visit(), "HTTP/1.1 200 OK");
}

TEST_F(PageServerTest, whoHasAskedKeepsItsPlace) {
  const Visitor early(server->port());
  const std::string request = "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n";
  early.say(request);
  EXPECT_EQ(early.line(farOff * 1000), "HTTP/1.1 200 OK");
  std::list<Visitor> silent;
  for (int i = 0; i < 200; ++i) silent.emplace_back(server->port());
  EXPECT_EQ(visit(), "HTTP/1.1 200 OK");
  while (early.line(0) != "silence") {  // the rest of the page
  }
  early.say(request);
  EXPECT_EQ(early.line(farOff * 1000), "HTTP/1.1 200 OK");
}

}  // namespace
}  // namespace plumbline::pages
