#include "tunnel/RankLink.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <deque>
#include <functional>
#include <list>

#include "support/Thrown.h"
#include "tunnel/TestSockets.h"

namespace plumbline::tunnel {
namespace {

/// Both ends of a link, with what is on its way between them.
struct LinkPair {
  LinkPair() { port = clients.listen(); }
  void serve(RankLink& link) {
    std::vector<pollfd> watched;
    link.watch(watched);
    poll(watched.data(), watched.size(), 1);
    EXPECT_EQ(link.serve(watched, now), watched.size());
  }
  void step() {
    now += 0.01;
    serve(clients);
    serve(servers);
    for (; !toServers.empty(); toServers.pop_front())
      servers.take(decodeFrame(encodeFrame(toServers.front())), now);
    for (; !toClients.empty(); toClients.pop_front())
      clients.take(decodeFrame(encodeFrame(toClients.front())), now);
  }
  bool until(const std::function<bool()>& holds) {
    for (int i = 0; i < 3000; ++i) {
      if (holds()) return true;
      step();
    }
    return false;
  }

  int port = 0;
  double now = 0;
  std::deque<Frame> toServers, toClients;
  RankLink clients{[this](const Frame& frame) { toServers.push_back(frame); }};
  RankLink servers{[this](const Frame& frame) { toClients.push_back(frame); }};
};

struct RankLinkTest : testing::Test, LinkPair {
  RankLinkTest() { servers.connectTo(server.port, 1); }
  TestSocket accepted() {
    std::optional<TestSocket> socket;
    EXPECT_TRUE(until([&] { return (socket = server.accept()).has_value(); }));
    return std::move(*socket);
  }
  bool comes(TestSocket& socket, const std::string& text) {
    return until([&] {
      socket.receive();
      return socket.received == text;
    });
  }
  bool breaks(TestSocket& socket) {
    return until([&] {
      socket.receive();
      return socket.error != 0;
    });
  }
  TestServer server;
};

TEST_F(RankLinkTest, carriesBytesBothWaysAndItsEnds) {
  TestSocket client = TestSocket::connected(port), atServer = accepted();
  client.send("hello");
  EXPECT_TRUE(comes(atServer, "hello"));
  atServer.send("welcome");
  EXPECT_TRUE(comes(client, "welcome"));
  client.close();
  EXPECT_TRUE(until([&] {
    atServer.receive();
    return atServer.ended;
  }));
  atServer.close();
  EXPECT_TRUE(until([&] { return clients.connections() == 0 && servers.connections() == 0; }));
}

TEST_F(RankLinkTest, oneWayMayEndWhileTheOtherGoesOn) {
  TestSocket client = TestSocket::connected(port), atServer = accepted();
  client.send("all I have");
  client.finish();
  EXPECT_TRUE(comes(atServer, "all I have"));
  EXPECT_TRUE(until([&] {
    atServer.receive();
    return atServer.ended;
  }));
  EXPECT_EQ(clients.connections(), 1U);
  atServer.send("then take this");
  EXPECT_TRUE(comes(client, "then take this"));
  EXPECT_FALSE(client.ended);
  atServer.finish();
  EXPECT_TRUE(until([&] {
    client.receive();
    return client.ended;
  }));
  EXPECT_TRUE(until([&] { return clients.connections() == 0 && servers.connections() == 0; }));
}

TEST_F(RankLinkTest, aConnectionThatBreaksBreaksAtTheOtherEnd) {
  TestSocket client = TestSocket::connected(port), atServer = accepted();
  client.send("x");
  EXPECT_TRUE(comes(atServer, "x"));
  atServer.breakOff();
  EXPECT_TRUE(breaks(client));
  EXPECT_EQ(client.error, ECONNRESET);
  EXPECT_TRUE(until([&] { return clients.connections() == 0 && servers.connections() == 0; }));
}

TEST_F(RankLinkTest, whatWasSentBeforeItBrokeArrives) {
  TestSocket client = TestSocket::connected(port), atServer = accepted();
  client.send("last words");
  for (int i = 0; i < 5; ++i) step();
  client.breakOff();
  EXPECT_TRUE(breaks(atServer));
  EXPECT_EQ(atServer.received, "last words");
}

TEST_F(RankLinkTest, carriesManyConnectionsAtOnceEachByItself) {
  std::list<TestSocket> sockets, atServer;
  for (int i = 0; i < 50; ++i) {
    sockets.push_back(TestSocket::connected(port));
    sockets.back().send("client " + std::to_string(i));
  }
  for (int i = 0; i < 50; ++i) atServer.push_back(accepted());
  EXPECT_EQ(servers.connections(), 50U);
  for (TestSocket& one : atServer) {
    EXPECT_TRUE(until([&] {
      one.receive();
      return one.received.size() >= 8;
    }));
    one.send("for " + one.received);
  }
  int number = 0;
  for (TestSocket& one : sockets) EXPECT_TRUE(comes(one, "for client " + std::to_string(number++)));
}

TEST_F(RankLinkTest, aSenderIsHeldUpByAReceiverThatDoesNotRead) {
  TestSocket client = TestSocket::connected(port), atServer = accepted();
  const std::string block(1 << 16, 'b');
  std::size_t sent = 0, onTheWay = 0;
  for (int i = 0; i < 500; ++i) {
    sent += client.send(block);
    std::size_t data = 0;
    serve(clients);
    for (const Frame& frame : toServers) data += frame.data.size();
    onTheWay = std::max(onTheWay, data);
    step();
  }
  EXPECT_LE(onTheWay, creditWindow);
  EXPECT_LT(sent, 64U << 20);  // what the kernel's buffers hold, and the window
  EXPECT_FALSE(servers.quiet());
  EXPECT_TRUE(until([&] {
    atServer.receive();
    return atServer.received.size() == sent;
  }));
  sent += client.send("more");
  EXPECT_TRUE(until([&] {
    atServer.receive();
    return atServer.received.size() == sent;
  }));
}

TEST_F(RankLinkTest, megabytesArriveAsTheyWereSent) {
  TestSocket client = TestSocket::connected(port), atServer = accepted();
  std::string bytes(3'000'000, ' ');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 2654435761U >> 13);
  std::size_t there = 0, back = 0;
  EXPECT_TRUE(until([&] {
    there += client.send(std::string_view(bytes).substr(there));
    back += atServer.send(std::string_view(bytes).substr(back));
    client.receive();
    atServer.receive();
    return client.received.size() == bytes.size() && atServer.received.size() == bytes.size();
  }));
  EXPECT_TRUE(client.received == bytes);
  EXPECT_TRUE(atServer.received == bytes);
}

TEST_F(RankLinkTest, aServerThatIsNotThereYetIsWaitedForThenRefusedAtOnce) {
  int later = 0;
  ::close(farm::listenOn("127.0.0.1", 0, later));
  servers.connectTo(later, 100);
  TestSocket client = TestSocket::connected(port);
  client.send("early");
  for (int i = 0; i < 50; ++i) step();
  EXPECT_EQ(servers.connections(), 1U);
  int had = 0;
  const int listener = farm::listenOn("127.0.0.1", later, had);
  int fd = -1;
  EXPECT_TRUE(until([&] { return (fd = accept4(listener, nullptr, nullptr, SOCK_NONBLOCK)) >= 0; }));
  TestSocket atServer(fd);
  EXPECT_TRUE(comes(atServer, "early"));
  ::close(listener);
  TestSocket late = TestSocket::connected(port);
  EXPECT_TRUE(breaks(late));
}

TEST_F(RankLinkTest, clientsThatCameTooEarlyAllReachTheServerOnceItIsThere) {
  int later = 0;
  ::close(farm::listenOn("127.0.0.1", 0, later));
  servers.connectTo(later, 100);
  std::list<TestSocket> early;
  for (int i = 0; i < 5; ++i) {  // each is tried again at another time
    early.push_back(TestSocket::connected(port));
    step();
  }
  for (int i = 0; i < 20; ++i) step();
  int had = 0;
  const int listener = farm::listenOn("127.0.0.1", later, had);
  std::list<TestSocket> atServer;
  EXPECT_TRUE(until([&] {
    if (const int fd = accept4(listener, nullptr, nullptr, SOCK_NONBLOCK); fd >= 0) atServer.emplace_back(fd);
    return atServer.size() == early.size();
  }));
  ::close(listener);
}

TEST_F(RankLinkTest, aSocketThatMetItselfIsNoServer) {
  // To connect to a port where nobody listens, from just this port, succeeds.
  const int fd = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* general = reinterpret_cast<sockaddr*>(&where);
  socklen_t size = sizeof where;
  ASSERT_EQ(bind(fd, general, size), 0);
  ASSERT_EQ(getsockname(fd, general, &size), 0);
  ASSERT_EQ(connect(fd, general, size), 0);
  EXPECT_TRUE(isItsOwnPeer(fd));
  ::close(fd);
  const int other = farm::connectTo("127.0.0.1", port);
  EXPECT_FALSE(isItsOwnPeer(other));
  ::close(other);
}

TEST_F(RankLinkTest, whereNoFileCanBeOpenedItPausesAndTakesTheClientLater) {
  TestSocket client = TestSocket::connected(port);
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const int free = dup(STDIN_FILENO);
  ::close(free);
  const rlimit none{static_cast<rlim_t>(free), before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  now = 1;
  serve(clients);
  std::vector<pollfd> watched;
  clients.watch(watched);
  clients.serve(watched, now);
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_EQ(watched.at(0).fd, -1);  // else poll() would return at once, again and again
  EXPECT_EQ(clients.connections(), 0U);
  client.send("late");
  TestSocket atServer = accepted();
  EXPECT_TRUE(comes(atServer, "late"));
}

TEST_F(RankLinkTest, theWaitForAServerIsBounded) {
  int nobody = 0;
  ::close(farm::listenOn("127.0.0.1", 0, nobody));
  servers.connectTo(nobody, 0.3);
  TestSocket client = TestSocket::connected(port);
  EXPECT_TRUE(breaks(client));
  EXPECT_GE(now, 0.3);
  EXPECT_LT(now, 0.6);
}

TEST_F(RankLinkTest, itsPortIsOnLoopbackAlone) {
  sockaddr_in where{};
  socklen_t size = sizeof where;
  const int fd = farm::connectTo("127.0.0.1", port);
  getpeername(fd, reinterpret_cast<sockaddr*>(&where), &size);
  EXPECT_EQ(ntohl(where.sin_addr.s_addr), INADDR_LOOPBACK);
  ::close(fd);
  clients.stopListening();
  EXPECT_EQ(thrownBy([&] { farm::connectTo("127.0.0.1", port); }),
            "cannot reach 127.0.0.1:" + std::to_string(port) + ": Connection refused");
}

TEST_F(RankLinkTest, framesThatBreakTheProtocolAreRefused) {
  const auto refused = [&](RankLink& link, const Frame& frame) {
    return thrownBy([&] { link.take(frame, now); });
  };
  EXPECT_EQ(refused(servers, {FrameKind::data, 1, 0, "x"}), "a frame of connection 1, which nobody opened");
  EXPECT_EQ(refused(servers, {FrameKind::open, 2}), "connection 2 after connection 0");
  EXPECT_EQ(refused(clients, {FrameKind::open, 1}), "a connection that begins at the wrong end");
  clients.stopListening();
  EXPECT_EQ(refused(clients, {FrameKind::open, 1}), "a connection that begins at the wrong end");
  servers.take({FrameKind::open, 1}, now);
  EXPECT_EQ(refused(servers, {FrameKind::open, 1}), "connection 1 after connection 1");
  EXPECT_EQ(refused(servers, {FrameKind::credit, 1, 1}), "credit for more than connection 1 has sent");
  EXPECT_EQ(refused(servers, {FrameKind::alive, 1}), "a frame that is none of connection 1");
  servers.take({FrameKind::end, 1}, now);
  EXPECT_EQ(refused(servers, {FrameKind::data, 1, 0, "x"}), "data after the end of connection 1");
}

TEST_F(RankLinkTest, moreThanTheWindowIsRefused) {
  int nobody = 0;
  ::close(farm::listenOn("127.0.0.1", 0, nobody));
  servers.connectTo(nobody, 100);
  servers.take({FrameKind::open, 1}, now);
  const std::string most(maxFrameData, 'x');
  for (std::size_t i = 0; i < creditWindow / maxFrameData; ++i)
    servers.take({FrameKind::data, 1, 0, most}, now);
  EXPECT_EQ(thrownBy([&] {
              servers.take({FrameKind::data, 1, 0, "x"}, now);
            }),
            "more than the 262144 bytes that connection 1 may be sent");
}

TEST_F(RankLinkTest, whatIsOnItsWayToAConnectionThatHasGoneIsDropped) {
  servers.take({FrameKind::open, 1}, now);
  servers.take({FrameKind::reset, 1}, now);
  EXPECT_EQ(servers.connections(), 0U);
  for (const FrameKind kind : {FrameKind::data, FrameKind::end, FrameKind::reset, FrameKind::credit})
    EXPECT_NO_THROW(servers.take({kind, 1, 1, kind == FrameKind::data ? "x" : ""}, now));
}

TEST_F(RankLinkTest, oneConnectionTooManyIsBrokenOffAndNoOther) {
  for (std::uint32_t i = 1; i <= RankLink::maxConnections; ++i) servers.take({FrameKind::open, i}, now);
  toClients.clear();
  servers.take({FrameKind::open, RankLink::maxConnections + 1}, now);
  ASSERT_EQ(toClients.size(), 1U);
  EXPECT_EQ(toClients[0].kind, FrameKind::reset);
  EXPECT_EQ(toClients[0].connection, RankLink::maxConnections + 1);
}

}  // namespace
}  // namespace plumbline::tunnel
