#pragma once
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>

namespace plumbline::test {

/// A UDP port of the loopback interface, as a viewer of drawings has one.
class ViewerPort {
public:
  ViewerPort() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* general = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(bind(fd_, general, size), 0);
    EXPECT_EQ(getsockname(fd_, general, &size), 0);
    port = ntohs(address.sin_port);
    const timeval patience{5, 0};
    setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ~ViewerPort() { close(fd_); }
  ViewerPort(const ViewerPort&) = delete;
  ViewerPort& operator=(const ViewerPort&) = delete;

  /// The next datagram; empty if none comes within five seconds.
  std::string received() {
    std::array<char, 1024> bytes{};
    const ssize_t got = recv(fd_, bytes.data(), bytes.size(), 0);
    return got > 0 ? std::string(bytes.data(), static_cast<std::size_t>(got)) : "";
  }
  int port = 0;

private:
  int fd_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

}  // namespace plumbline::test
