#include "simspark/Connection.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace plumbline::simspark {

namespace {

using Clock = std::chrono::steady_clock;

/// Milliseconds until a point in time, for poll.
int millisecondsUntil(Clock::time_point end) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
  return left < 0 ? 0 : static_cast<int>(std::min<long long>(left, 1 << 30));
}

Clock::time_point after(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// Connects a socket within the time; returns errno, 0 on success.
int connectWithin(int fd, const addrinfo& address, Clock::time_point end) {
  const int flags = fcntl(fd, F_GETFL);
  fcntl(fd, F_SETFL, flags | O_NONBLOCK);
  if (::connect(fd, address.ai_addr, address.ai_addrlen) != 0) {
    if (errno != EINPROGRESS) return errno;
    pollfd waiting{fd, POLLOUT, 0};
    int ready = 0;
    do ready = poll(&waiting, 1, millisecondsUntil(end));
    while (ready < 0 && errno == EINTR);
    if (ready == 0) return ETIMEDOUT;
    int result = 0;
    socklen_t size = sizeof result;
    if (ready < 0 || getsockopt(fd, SOL_SOCKET, SO_ERROR, &result, &size) != 0) return errno;
    if (result != 0) return result;
  }
  fcntl(fd, F_SETFL, flags);
  return 0;
}

}  // namespace

Connection::Connection(Connection&& other) noexcept
    : fd(std::exchange(other.fd, -1)),
      reader(std::move(other.reader)),
      outgoing(std::move(other.outgoing)),
      lastError(std::move(other.lastError)) {}

Connection& Connection::operator=(Connection&& other) noexcept {
  if (this != &other) {
    close();
    fd = std::exchange(other.fd, -1);
    reader = std::move(other.reader);
    outgoing = std::move(other.outgoing);
    lastError = std::move(other.lastError);
  }
  return *this;
}

std::string Connection::connect(const std::string& host, int port, double timeoutSeconds) {
  close();
  const std::string where = "cannot connect to " + host + ":" + std::to_string(port) + ": ";
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int code = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found); code != 0)
    return lastError = where + gai_strerror(code);
  const auto end = after(timeoutSeconds);
  int problem = ECONNREFUSED;
  for (const addrinfo* address = found; address && fd < 0; address = address->ai_next) {
    fd = socket(address->ai_family, address->ai_socktype | SOCK_CLOEXEC, address->ai_protocol);
    problem = fd < 0 ? errno : connectWithin(fd, *address, end);
    if (problem != 0) close();
  }
  freeaddrinfo(found);
  if (fd < 0) return lastError = where + std::strerror(problem);
  const int on = 1;
  setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  lastError.clear();
  return {};
}

void Connection::close() {
  if (fd >= 0) ::close(fd);
  fd = -1;
  reader.reset();
}

Connection::Status Connection::fail(const std::string& why) {
  lastError = why;
  if (fd >= 0) ::close(fd);
  fd = -1;
  return Status::closed;
}

Connection::Status Connection::receive(std::string_view& message, double timeoutSeconds) {
  const auto end = timeoutSeconds > 0 ? after(timeoutSeconds) : Clock::time_point();
  for (;;) {
    const auto status = reader.next(message);
    if (status == FrameReader::Status::message) return Status::message;
    if (status == FrameReader::Status::tooLong)
      return fail("a message of " + std::to_string(reader.announced()) + " bytes was announced");
    if (fd < 0) return fail("not connected");
    pollfd waiting{fd, POLLIN, 0};
    const int ready = poll(&waiting, 1,
                           timeoutSeconds < 0   ? -1
                           : timeoutSeconds > 0 ? millisecondsUntil(end)
                                                : 0);
    if (ready == 0) return Status::timeout;
    if (ready < 0) {
      if (errno == EINTR) return Status::timeout;  // a signal: let the caller look around
      return fail(std::strerror(errno));
    }
    std::array<char, 1 << 16> bytes;
    const ssize_t n = recv(fd, bytes.data(), bytes.size(), 0);
    // The league's server gathers small messages until the last is acknowledged, and who only listens, as a
    // monitor does, acknowledges 40 ms late unless told each time.
    const int on = 1;
    setsockopt(fd, IPPROTO_TCP, TCP_QUICKACK, &on, sizeof on);
    if (n == 0) return fail("the other side closed the connection");
    if (n < 0) {
      if (errno == EINTR || errno == EAGAIN) continue;
      return fail(std::strerror(errno));
    }
    reader.feed(std::string_view(bytes.data(), static_cast<std::size_t>(n)));
  }
}

bool Connection::send(std::string_view text) {
  if (fd < 0) return false;
  outgoing.clear();
  appendFrame(outgoing, text);
  for (std::size_t sent = 0; sent < outgoing.size();) {
    const ssize_t n = ::send(fd, outgoing.data() + sent, outgoing.size() - sent, MSG_NOSIGNAL);
    if (n < 0) {
      if (errno == EINTR) continue;
      fail(std::strerror(errno));
      return false;
    }
    sent += static_cast<std::size_t>(n);
  }
  return true;
}

}  // namespace plumbline::simspark
