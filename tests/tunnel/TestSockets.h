#pragma once
#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <string>
#include <utility>

#include "optimization/farm/LineSocket.h"

namespace plumbline::tunnel {

/// A plain TCP socket of a test, which never waits.
class TestSocket {
public:
  explicit TestSocket(int fd) : fd_(fd) {}
  TestSocket(TestSocket&& other) noexcept : fd_(other.fd_) { other.fd_ = -1; }
  TestSocket(const TestSocket&) = delete;
  TestSocket& operator=(TestSocket&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~TestSocket() { close(); }
  static TestSocket connected(int port) { return TestSocket(farm::connectTo("127.0.0.1", port)); }

  /// How many bytes were taken.
  std::size_t send(std::string_view bytes) {
    const ssize_t count = ::send(fd_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    return count < 0 ? 0 : static_cast<std::size_t>(count);
  }
  /// Takes in what has come; afterwards `ended` and `error` say whether more may.
  void receive() {
    char buffer[65536];
    for (;;) {
      const ssize_t count = recv(fd_, buffer, sizeof buffer, MSG_DONTWAIT);
      if (count > 0) {
        received.append(buffer, static_cast<std::size_t>(count));
        continue;
      }
      ended = ended || count == 0;
      if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK) error = errno;
      return;
    }
  }
  void finish() const { shutdown(fd_, SHUT_WR); }
  void breakOff() {
    const linger now{1, 0};
    setsockopt(fd_, SOL_SOCKET, SO_LINGER, &now, sizeof now);
    close();
  }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

  std::string received;
  bool ended = false;
  int error = 0;

private:
  int fd_;
};

/// A server's port on loopback.
class TestServer {
public:
  TestServer() : fd_(farm::listenOn("127.0.0.1", 0, port)) {}
  ~TestServer() { ::close(fd_); }
  TestServer(const TestServer&) = delete;
  TestServer& operator=(const TestServer&) = delete;
  std::optional<TestSocket> accept() const {
    const int fd = accept4(fd_, nullptr, nullptr, SOCK_NONBLOCK);
    return fd < 0 ? std::nullopt : std::optional<TestSocket>(fd);
  }
  int port = 0;

private:
  int fd_;
};

}  // namespace plumbline::tunnel
