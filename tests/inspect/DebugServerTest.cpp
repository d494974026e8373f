#include "inspect/DebugServer.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <list>
#include <memory>
#include <thread>

#include "framework/DebugSite.h"
#include "support/Thrown.h"

namespace plumbline::inspect {
namespace {

/// A client; what is read is bounded by ten seconds.
class Peer {
public:
  explicit Peer(int port, int receiveBuffer = 0) : fd_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (receiveBuffer > 0) setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &receiveBuffer, sizeof(receiveBuffer));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  ~Peer() { close(fd_); }
  /// The connection breaks: what the server reads next is an error, not an end.
  void resetAtClose() const {
    const linger now{1, 0};
    setsockopt(fd_, SOL_SOCKET, SO_LINGER, &now, sizeof now);
  }

  bool say(const std::string& text) {
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t done = send(fd_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (done <= 0) return false;
      sent += static_cast<std::size_t>(done);
    }
    return true;
  }
  /// The next line; "closed" at the end, "silence" after ten seconds.
  std::string line() {
    for (;;) {
      if (const auto end = in_.find('\n'); end != std::string::npos) {
        const std::string result = in_.substr(0, end);
        in_.erase(0, end + 1);
        return result;
      }
      pollfd ready{fd_, POLLIN, 0};
      if (poll(&ready, 1, 10000) <= 0) return "silence";
      char buffer[4096];
      const ssize_t got = recv(fd_, buffer, sizeof(buffer), 0);
      if (got <= 0) return "closed";
      in_.append(buffer, static_cast<std::size_t>(got));
    }
  }

private:
  int fd_;
  std::string in_;
};

/// A server in a thread, and a thread that passes a point all the time, as an agent would.
struct DebugServerTest : testing::Test {
  AgentDebug agent;
  Inspector inspector{agent};
  std::unique_ptr<DebugServer> server;
  int end = eventfd(0, 0);
  std::atomic<bool> stop = false;
  std::thread serving, passing;

  void start(const std::string& token = "") {
    server = std::make_unique<DebugServer>(inspector, DebugServerOptions{"127.0.0.1", 0, token});
    serving = std::thread([this] { server->serve(end); });
    passing = std::thread([this] {
      std::string value(2000, 'x');
      while (!stop) {
        MODIFY("server:value", value);
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    });
    while (!DebugPoints::sites().find("server:value")) std::this_thread::yield();
  }
  ~DebugServerTest() override {
    stop = true;
    const std::uint64_t one = 1;
    EXPECT_EQ(write(end, &one, sizeof(one)), 8);
    if (serving.joinable()) serving.join();
    if (passing.joinable()) passing.join();
    server.reset();
    close(end);
  }
  std::string ask(const std::string& command) {
    Peer peer(server->port());
    peer.say(command + "\n");
    return peer.line();
  }
};

TEST_F(DebugServerTest, answersLines) {
  start();
  Peer peer(server->port());
  peer.say("setOnce server:value \"abc\"\r\nget nothing\n#1 list server:va");
  EXPECT_EQ(peer.line(), "error: nothing is called nothing");
  EXPECT_EQ(peer.line(), "ok");
  peer.say("lue\n");
  EXPECT_EQ(peer.line(), "#1 server:value  modify");
}

TEST_F(DebugServerTest, aLineOfAMegabyteEndsItsClientAlone) {
  start();
  Peer good(server->port()), bad(server->port());
  bad.say(std::string(1 << 20, 'a'));
  EXPECT_EQ(bad.line(), "error: a line is longer than 65536 bytes");
  good.say("get nothing\n");
  EXPECT_EQ(good.line(), "error: nothing is called nothing");
}

TEST_F(DebugServerTest, aConnectionThatBreaksHindersNobodyElse) {
  start();
  Peer good(server->port());
  for (int i = 0; i < 20; ++i) {
    Peer broken(server->port());
    broken.resetAtClose();
    broken.say("get nothing\n");
    EXPECT_EQ(broken.line(), "error: nothing is called nothing");
  }
  good.say("get nothing\n");
  EXPECT_EQ(good.line(), "error: nothing is called nothing");
}

TEST_F(DebugServerTest, bytesThatAreNoTextAreAnError) {
  start();
  EXPECT_EQ(ask(std::string("\0\xff\x01", 3)).substr(0, 18), "error: no command ");
}

TEST_F(DebugServerTest, aClientThatReadsNothingMissesValuesAndHoldsNobodyUp) {
  start();
  bool reported = false;
  // A busy machine needs longer until more is waiting than is kept.
  for (int halfSeconds = 1; halfSeconds <= 32 && !reported; halfSeconds *= 2) {
    Peer lazy(server->port(), 4096);
    for (int i = 0; i < 50; ++i) lazy.say("watch server:value\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(500 * halfSeconds));
    EXPECT_EQ(ask("get nothing"), "error: nothing is called nothing");
    lazy.say("unwatch\n");
    for (std::string line = lazy.line(); line != "ok" && line != "closed" && line != "silence";
         line = lazy.line())
      reported = reported || line.ends_with(" lines were left out: the client reads too slowly");
  }
  EXPECT_TRUE(reported);
}

TEST_F(DebugServerTest, silentClientsGiveWay) {
  start();
  Peer early(server->port());
  early.say("get nothing\n");
  EXPECT_EQ(early.line(), "error: nothing is called nothing");
  const int page = server->join();
  std::list<Peer> silent;
  for (int i = 0; i < 300; ++i) silent.emplace_back(server->port());
  EXPECT_EQ(ask("get nothing"), "error: nothing is called nothing");
  EXPECT_EQ(silent.front().line(), "error: you have said nothing, and other clients need the place");
  EXPECT_EQ(silent.front().line(), "closed");
  early.say("get nothing\n");
  EXPECT_EQ(early.line(), "error: nothing is called nothing") << "who has said something keeps its place";
  char byte = 0;
  EXPECT_EQ(recv(page, &byte, 1, MSG_DONTWAIT), -1) << "and who belongs to the program";
  EXPECT_EQ(errno, EAGAIN);
  close(page);
}

TEST_F(DebugServerTest, silentClientsGiveWayBeforeATokenToo) {
  start("secret");
  std::list<Peer> silent;
  for (int i = 0; i < 300; ++i) silent.emplace_back(server->port()).say("sec");
  EXPECT_EQ(ask("secret\nget nothing"), "error: nothing is called nothing");
}

TEST_F(DebugServerTest, whoComesWhenAllHaveSpokenIsSentAway) {
  start();
  std::list<Peer> clients;
  for (std::size_t i = 0; i < DebugServer::maxClients; ++i) {
    clients.emplace_back(server->port()).say("get nothing\n");
    EXPECT_EQ(clients.back().line(), "error: nothing is called nothing");
  }
  EXPECT_EQ(ask("get nothing"), "error: too many clients: 256 are there");
}

TEST_F(DebugServerTest, wantsItsTokenFirst) {
  start("secret");
  Peer good(server->port()), bad(server->port());
  bad.say("get nothing\n");
  EXPECT_EQ(bad.line(), "error: the first line must be the token");
  EXPECT_EQ(bad.line(), "closed");
  good.say("secret\nget nothing\n");
  EXPECT_EQ(good.line(), "error: nothing is called nothing");
}

TEST(DebugServerOptionsTest, whatCannotBeIsAnErrorInOneLine) {
  AgentDebug agent;
  Inspector inspector(agent);
  const auto made = [&](const DebugServerOptions& options) {
    return thrownBy([&] { const DebugServer server(inspector, options); });
  };
  EXPECT_EQ(made({"0.0.0.0", 0, ""}), "debug port 0.0.0.0:0 is open to others: that needs a token");
  EXPECT_EQ(made({"example", 0, "t"}), "debug port: example is no IPv4 address, as 127.0.0.1");
  const DebugServer first(inspector, {"127.0.0.1", 0, ""});
  EXPECT_EQ(made({"127.0.0.1", first.port(), ""}),
            "debug port 127.0.0.1:" + std::to_string(first.port()) + ": Address already in use");
}

}  // namespace
}  // namespace plumbline::inspect
