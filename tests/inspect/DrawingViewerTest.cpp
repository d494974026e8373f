#include "inspect/DrawingViewer.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

#include "support/Thrown.h"

namespace plumbline::inspect {
namespace {

/// A viewer's port.
struct DrawingViewerTest : testing::Test {
  int fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0), port = 0;
  DrawingOwner owner;

  DrawingViewerTest() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* general = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(bind(fd, general, size), 0);
    EXPECT_EQ(getsockname(fd, general, &size), 0);
    port = ntohs(address.sin_port);
    const timeval patience{5, 0};
    setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ~DrawingViewerTest() override { close(fd); }
  std::string received() {
    std::array<char, 1024> bytes{};
    const ssize_t got = recv(fd, bytes.data(), bytes.size(), 0);
    return got > 0 ? std::string(bytes.data(), static_cast<std::size_t>(got)) : "";
  }
};

TEST_F(DrawingViewerTest, setsAreNamedByTeamAndNumber) {
  const DrawingViewer viewer({"127.0.0.1", port}, owner);
  Drawing drawing;
  drawing.point(Vec2(1, 2), {10, 20, 30}, 5);
  owner.number = 7;
  viewer.show("draw:BallLocator:ball", drawing);
  const std::string name("left.07.BallLocator:ball.\0", 26);
  EXPECT_EQ(received(), std::string("\x01\x02", 2) + "1.00002.00000.00005.0000" + "\x0a\x14\x1e" + name +
                            std::string("\0\0", 2) + name);
  owner.right = true;
  viewer.show("draw:BallLocator:ball", {});
  EXPECT_EQ(received(), std::string("\0\0", 2) + std::string("right.07.BallLocator:ball.\0", 27));
}

TEST_F(DrawingViewerTest, anAddressIsWrittenInDigits) {
  EXPECT_EQ(thrownBy([&] {
              DrawingViewer({"viewer", port}, owner);
            }),
            "drawings: viewer is no IPv4 address, as 127.0.0.1");
}

}  // namespace
}  // namespace plumbline::inspect
