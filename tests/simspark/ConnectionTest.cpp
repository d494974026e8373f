// No call of a connection outlasts its time limit or the request to stop.
#include "simspark/Connection.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace plumbline::simspark {
namespace {

/// Takes connections and never reads.
class DeafServer : public testing::Test {
protected:
  DeafServer() : listener(socket(AF_INET, SOCK_STREAM, 0)), stop(eventfd(0, EFD_CLOEXEC)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(listener, 4), 0);
    getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
    port = ntohs(address.sin_port);
  }
  ~DeafServer() override {
    close(listener);
    close(stop);
  }
  void requestStop() const {
    const std::uint64_t one = 1;
    EXPECT_EQ(write(stop, &one, sizeof one), static_cast<ssize_t>(sizeof one));
  }

  int listener, stop, port = 0;
  const std::string much = std::string(1 << 16, 'x');
};

TEST_F(DeafServer, isGivenUpAfterTheTime) {
  Connection connection;
  ASSERT_EQ(connection.connect("127.0.0.1", port), "");
  int sent = 0;
  while (sent < 1000 && connection.send(much, 0.05)) ++sent;
  EXPECT_GT(sent, 0);
  EXPECT_LT(sent, 1000);
  EXPECT_FALSE(connection.connected());
  EXPECT_EQ(connection.error(), "the other side does not read");
}

TEST_F(DeafServer, doesNotHoldUpTheStop) {
  Connection connection;
  connection.interruptBy(stop);
  ASSERT_EQ(connection.connect("localhost", port), "");
  std::atomic<bool> waits = false;
  std::thread sender([&] {
    while (connection.send(much, 3600)) waits = true;
  });
  while (!waits) usleep(1000);
  requestStop();
  sender.join();  // would take an hour
  EXPECT_EQ(connection.error(), "interrupted");
  EXPECT_EQ(connection.connect("127.0.0.1", port),
            "cannot connect to 127.0.0.1:" + std::to_string(port) + ": Operation canceled");
  connection.interruptBy(-1);
  ASSERT_EQ(connection.connect("127.0.0.1", port), "");
  connection.interruptBy(stop);
  std::string_view message;
  EXPECT_EQ(connection.receive(message, 3600), Connection::Status::timeout);
}

TEST_F(DeafServer, whoListensOnlyIsNotKeptWaitingByWhatItSaid) {
  // The league's server writes the second of two small messages only when the first is acknowledged.
  Connection monitor;
  monitor.listensOnly();
  ASSERT_EQ(monitor.connect("127.0.0.1", port), "");
  const int server = accept(listener, nullptr, nullptr);
  const std::string frame("\0\0\0\1x", 5);
  constexpr int rounds = 250;
  int slow = 0;
  for (int i = 0; i < rounds; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_TRUE(monitor.send("(kickOff Left)"));
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(send(server, frame.data(), frame.size(), 0), 5);
      std::string_view message;
      ASSERT_EQ(monitor.receive(message, 60), Connection::Status::message);
    }
    if (std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(20)) ++slow;
  }
  // Kept waiting, nearly every round would take 40 ms; on a busy machine others hold up some of them.
  EXPECT_LT(slow, rounds / 2);
  close(server);
}

}  // namespace
}  // namespace plumbline::simspark
