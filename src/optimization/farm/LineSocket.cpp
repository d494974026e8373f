#include "optimization/farm/LineSocket.h"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "framework/ConnectedSocket.h"

namespace plumbline::farm {
namespace {

static_assert(POLLIN == 1 && POLLOUT == 4);

constexpr double connectSeconds = 10;

void prepare(int fd) {
  const int on = 1;
  setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

}  // namespace

int listenOn(const std::string& address, int port, int& portHad) {
  const std::string place = "port " + address + ':' + std::to_string(port);
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_port = htons(static_cast<std::uint16_t>(port));
  const std::string numeric = address == "localhost" ? "127.0.0.1" : address;
  if (inet_pton(AF_INET, numeric.c_str(), &where.sin_addr) != 1)
    throw std::runtime_error(place + ": " + address + " is no IPv4 address, as 127.0.0.1");
  const int fd = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  socklen_t size = sizeof where;
  auto* general = reinterpret_cast<sockaddr*>(&where);
  if (fd < 0 || bind(fd, general, size) != 0 || listen(fd, SOMAXCONN) != 0 ||
      getsockname(fd, general, &size) != 0) {
    const std::string why = std::strerror(errno);
    if (fd >= 0) ::close(fd);
    throw std::runtime_error(place + ": " + why);
  }
  portHad = ntohs(where.sin_port);
  return fd;
}

int connectTo(const std::string& host, int port, int stopDescriptor) {
  const ConnectedSocket connected = connectSocket(host, port, connectSeconds, stopDescriptor);
  if (connected.descriptor < 0)
    throw std::runtime_error("cannot reach " + host + ':' + std::to_string(port) + ": " + connected.problem);
  return connected.descriptor;
}

LineSocket::LineSocket(int fd, std::size_t maxLine, std::size_t maxWaiting)
    : fd_(fd), maxLine_(maxLine), maxWaiting_(maxWaiting) {
  prepare(fd);
}

LineSocket::LineSocket(LineSocket&& other) noexcept
    : fd_(other.fd_),
      maxLine_(other.maxLine_),
      maxWaiting_(other.maxWaiting_),
      in_(std::move(other.in_)),
      out_(std::move(other.out_)),
      reason_(std::move(other.reason_)) {
  other.fd_ = -1;
}

LineSocket::~LineSocket() {
  if (fd_ >= 0) ::close(fd_);
}

void LineSocket::fail(const std::string& reason) {
  if (reason_.empty()) reason_ = reason;
}

void LineSocket::serve(short events) {
  if (events & POLLOUT) flush();
  if (events & (POLLIN | POLLHUP | POLLERR)) receive();
}

void LineSocket::receive() {
  char buffer[16384];
  for (;;) {
    if (in_.size() > 2 * maxLine_) return;  // its owner takes lines first
    const ssize_t count = recv(fd_, buffer, sizeof buffer, MSG_DONTWAIT);
    if (count > 0) {
      in_.append(buffer, static_cast<std::size_t>(count));
      continue;
    }
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    return fail(count == 0 ? "ended the connection" : std::strerror(errno));
  }
}

bool LineSocket::wait(double seconds, int stopDescriptor) {
  pollfd waiting[] = {{fd_, events(), 0}, {stopDescriptor, POLLIN, 0}};
  if (poll(waiting, 2, static_cast<int>(1e3 * seconds)) <= 0 || waiting[0].revents == 0) return false;
  serve(waiting[0].revents);
  return true;
}

bool LineSocket::next(std::string& line) {
  const std::size_t end = in_.find('\n');
  if (end == std::string::npos ? in_.size() > maxLine_ : end > maxLine_) {
    fail("sent a line of more than " + std::to_string(maxLine_) + " bytes");
    return false;
  }
  if (end == std::string::npos) return false;
  line = in_.substr(0, end);
  in_.erase(0, end + 1);
  return true;
}

void LineSocket::send(std::string_view line) {
  out_.append(line);
  out_ += '\n';
  flush();
  if (out_.size() > maxWaiting_) fail("does not accept the data sent to it");
}

void LineSocket::flush() {
  while (!out_.empty()) {
    const ssize_t count = ::send(fd_, out_.data(), out_.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count > 0) {
      out_.erase(0, static_cast<std::size_t>(count));
      continue;
    }
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    return fail(std::strerror(errno));
  }
}

}  // namespace plumbline::farm
