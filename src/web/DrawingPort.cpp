#include "web/DrawingPort.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace plumbline::web {

namespace {
constexpr int patience = 100;         ///< longest wait before looking at `stop` again [ms]
constexpr int kernelQueue = 4 << 20;  ///< bytes that may come while something else is done
}  // namespace

DrawingPort::DrawingPort(int port) {
  fd_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (fd_ < 0 || bind(fd_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      getsockname(fd_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    const std::string why = std::strerror(errno);
    if (fd_ >= 0) close(fd_);
    throw std::runtime_error("UDP port " + std::to_string(port) + " for drawings: " + why);
  }
  setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &kernelQueue, sizeof kernelQueue);
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { run(); });
}

DrawingPort::~DrawingPort() {
  stop_ = true;
  thread_.join();
  close(fd_);
}

std::optional<std::string> DrawingPort::takeChanges() {
  DrawingSets copy;
  {
    const std::lock_guard lock(mutex_);
    if (!changed_) return std::nullopt;
    changed_ = false;
    copy = sets_;
  }
  return copy.toJson();
}

void DrawingPort::run() {
  std::array<char, maxDatagram> bytes;
  std::vector<DrawingCommand> commands;
  while (!stop_) {
    pollfd waiting{fd_, POLLIN, 0};
    if (poll(&waiting, 1, patience) <= 0) continue;
    // What is longer than the buffer is cut by the system.
    const ssize_t size = recv(fd_, bytes.data(), bytes.size(), 0);
    if (size <= 0) continue;
    commands.clear();
    parseDrawings(std::string_view(bytes.data(), static_cast<std::size_t>(size)), commands);
    const std::lock_guard lock(mutex_);
    for (const DrawingCommand& command : commands) changed_ = sets_.apply(command) || changed_;
  }
}

}  // namespace plumbline::web
