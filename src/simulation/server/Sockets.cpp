#include "simulation/server/Sockets.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace plumbline::simulation {

using simspark::FrameReader;

namespace {

std::string addressText(const sockaddr* address, socklen_t size) {
  std::array<char, NI_MAXHOST> host;
  std::array<char, NI_MAXSERV> service;
  if (getnameinfo(address, size, host.data(), host.size(), service.data(), service.size(),
                  NI_NUMERICHOST | NI_NUMERICSERV) != 0)
    return "?";
  return std::string(host.data()) + ':' + service.data();
}

}  // namespace

Listener::Listener(const std::string& address, int port) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE | AI_NUMERICHOST | AI_NUMERICSERV;  // a name server might not answer
  addrinfo* found = nullptr;
  const std::string numeric = address == "localhost" ? "127.0.0.1" : address;
  if (const int code = getaddrinfo(numeric.c_str(), std::to_string(port).c_str(), &hints, &found); code != 0)
    throw std::runtime_error(
        "cannot listen on " + address + ": " +
        (code == EAI_NONAME ? "it is no address, as 127.0.0.1 or ::1" : gai_strerror(code)));
  fd_ = socket(found->ai_family, found->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, found->ai_protocol);
  const int on = 1;
  if (fd_ >= 0) setsockopt(fd_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  const bool good =
      fd_ >= 0 && bind(fd_, found->ai_addr, found->ai_addrlen) == 0 && listen(fd_, SOMAXCONN) == 0;
  const int problem = errno;
  freeaddrinfo(found);
  sockaddr_storage own{};
  socklen_t size = sizeof own;
  if (good && getsockname(fd_, reinterpret_cast<sockaddr*>(&own), &size) == 0) {
    port_ = ntohs(own.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6&>(own).sin6_port
                                            : reinterpret_cast<sockaddr_in&>(own).sin_port);
    return;
  }
  if (fd_ >= 0) close(fd_);
  throw std::runtime_error(
      problem == EADDRINUSE
          ? "port " + std::to_string(port) + " of " + address + " is in use; choose another or 0"
          : "cannot listen on " + address + ":" + std::to_string(port) + ": " + std::strerror(problem));
}

Listener::~Listener() { close(fd_); }

int Listener::accept(std::string& address) {
  sockaddr_storage other{};
  socklen_t size = sizeof other;
  const int client = accept4(fd_, reinterpret_cast<sockaddr*>(&other), &size, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (client < 0) return -1;
  const int on = 1;
  setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  address = addressText(reinterpret_cast<sockaddr*>(&other), size);
  return client;
}

FramedClient::FramedClient(int fd, std::string address, std::size_t maxMessage, std::size_t maxQueue)
    : fd_(fd),
      address_(std::move(address)),
      reader_(maxMessage),
      maxMessage_(maxMessage),
      maxQueue_(maxQueue) {}

FramedClient::~FramedClient() { close(fd_); }

pollfd FramedClient::watch() const {
  return {broken() ? -1 : fd_, static_cast<short>(queue_.empty() ? POLLIN : POLLIN | POLLOUT), 0};
}

void FramedClient::drop(const std::string& why) {
  if (!broken()) reason_ = why;
}

void FramedClient::serve(short events) {
  if (broken()) return;
  if (events & POLLOUT) flush();
  if (events & (POLLIN | POLLHUP | POLLERR)) read();
}

void FramedClient::read() {
  std::array<char, 1 << 14> bytes;
  // A client that sends without end must not keep the others waiting: a part is read now, the rest in the
  // next cycle.
  for (int round = 0; round < 8 && !broken(); ++round) {
    const ssize_t n = recv(fd_, bytes.data(), bytes.size(), 0);
    if (n == 0) return drop("closed the connection");
    if (n < 0) {
      if (errno != EAGAIN && errno != EINTR) drop(std::strerror(errno));
      return;
    }
    reader_.feed(std::string_view(bytes.data(), static_cast<std::size_t>(n)));
    if (static_cast<std::size_t>(n) < bytes.size()) return;
  }
}

bool FramedClient::next(std::string_view& message) {
  if (broken() && reader_.empty()) return false;
  switch (reader_.next(message)) {
    case FrameReader::Status::message:
      halfMessageSince_ = 0;
      return true;
    case FrameReader::Status::tooLong:
      drop("announced a message of " + std::to_string(reader_.announced()) + " bytes, at most " +
           std::to_string(maxMessage_) + " are read");
      return false;
    case FrameReader::Status::incomplete:
      break;
  }
  if (reader_.empty())
    halfMessageSince_ = 0;
  else if (halfMessageSince_ == 0)
    halfMessageSince_ = steadySeconds();
  return false;
}

void FramedClient::send(std::string_view text) {
  if (broken()) return;
  if (queue_.empty()) {  // the usual case: straight from the text
    std::string header;
    simspark::appendFrameHeader(header, text.size());
    iovec parts[2] = {{header.data(), header.size()}, {const_cast<char*>(text.data()), text.size()}};
    msghdr message{};
    message.msg_iov = parts;
    message.msg_iovlen = 2;
    const ssize_t n = sendmsg(fd_, &message, MSG_NOSIGNAL);
    if (n < 0 && errno != EAGAIN && errno != EINTR) return drop(std::strerror(errno));
    const std::size_t sent = n < 0 ? 0 : static_cast<std::size_t>(n);
    if (sent == header.size() + text.size()) return;
    queue_ = header;
    queue_ += text;
    queue_.erase(0, sent);
  } else {
    simspark::appendFrame(queue_, text);
  }
  if (queue_.size() > maxQueue_)
    drop("does not read: " + std::to_string(queue_.size()) + " bytes wait for it");
}

void FramedClient::flush() {
  if (queue_.empty()) return;
  const ssize_t n = ::send(fd_, queue_.data(), queue_.size(), MSG_NOSIGNAL);
  if (n > 0) queue_.erase(0, static_cast<std::size_t>(n));
  if (n < 0 && errno != EAGAIN && errno != EINTR) drop(std::strerror(errno));
}

}  // namespace plumbline::simulation
