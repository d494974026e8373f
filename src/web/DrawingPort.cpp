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
  fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (fd < 0 || bind(fd, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    const std::string why = std::strerror(errno);
    if (fd >= 0) close(fd);
    throw std::runtime_error("UDP port " + std::to_string(port) + " for drawings: " + why);
  }
  setsockopt(fd, SOL_SOCKET, SO_RCVBUF, &kernelQueue, sizeof kernelQueue);
  port_ = ntohs(address.sin_port);
  thread = std::thread([this] { run(); });
}

DrawingPort::~DrawingPort() {
  stop = true;
  thread.join();
  close(fd);
}

std::optional<std::string> DrawingPort::takeChanges() {
  DrawingSets copy;
  {
    const std::lock_guard lock(mutex);
    if (!changed) return std::nullopt;
    changed = false;
    copy = sets;
  }
  return copy.toJson();
}

void DrawingPort::run() {
  std::array<char, maxDatagram> bytes;
  std::vector<DrawingCommand> commands;
  while (!stop) {
    pollfd waiting{fd, POLLIN, 0};
    if (poll(&waiting, 1, patience) <= 0) continue;
    // What is longer than the buffer is cut by the system.
    const ssize_t size = recv(fd, bytes.data(), bytes.size(), 0);
    if (size <= 0) continue;
    commands.clear();
    parseDrawings(std::string_view(bytes.data(), static_cast<std::size_t>(size)), commands);
    const std::lock_guard lock(mutex);
    for (const DrawingCommand& command : commands) changed = sets.apply(command) || changed;
  }
}

}  // namespace plumbline::web
