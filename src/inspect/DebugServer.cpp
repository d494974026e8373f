#include "inspect/DebugServer.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "framework/Loopback.h"

namespace plumbline::inspect {
namespace {

constexpr int idleWait = 1000, busyWait = 5;  ///< [ms]
constexpr int linesAtOnce = 64;               ///< of a client before the others have their turn
constexpr int clientsAtOnce = 256;            ///< that are taken in before the others have their turn

}  // namespace

DebugServer::DebugServer(Inspector& inspector, const DebugServerOptions& options)
    : inspector_(inspector), token_(options.token) {
  joining_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (joining_ < 0) throw std::runtime_error("debug port: " + std::string(std::strerror(errno)));
  if (!options.listens) return;
  try {
    listen(options);
  } catch (...) {
    ::close(joining_);
    throw;
  }
}

void DebugServer::listen(const DebugServerOptions& options) {
  const std::string place = options.address + ':' + std::to_string(options.port);
  if (token_.empty() && !isLoopbackAddress(options.address))
    throw std::runtime_error("debug port " + place + " is open to others: that needs a token");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(options.port));
  const std::string numeric = options.address == "localhost" ? "127.0.0.1" : options.address;
  if (inet_pton(AF_INET, numeric.c_str(), &address.sin_addr) != 1)
    throw std::runtime_error("debug port: " + options.address + " is no IPv4 address, as 127.0.0.1");
  listener_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  socklen_t size = sizeof(address);
  auto* general = reinterpret_cast<sockaddr*>(&address);
  if (listener_ < 0 || bind(listener_, general, size) != 0 || ::listen(listener_, SOMAXCONN) != 0 ||
      getsockname(listener_, general, &size) != 0) {
    const std::string why = std::strerror(errno);
    if (listener_ >= 0) ::close(listener_);
    throw std::runtime_error("debug port " + place + ": " + why);
  }
  port_ = ntohs(address.sin_port);
}

DebugServer::~DebugServer() {
  for (const Client& client : clients_) close(client);
  for (const int fd : joined_) ::close(fd);
  if (listener_ >= 0) ::close(listener_);
  ::close(joining_);
}

int DebugServer::join() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error("debug port: " + std::string(std::strerror(errno)));
  const std::lock_guard lock(mutex_);
  joined_.push_back(ends[0]);
  const std::uint64_t one = 1;
  if (::write(joining_, &one, sizeof one) < 0) {  // full: it is readable already
  }
  return ends[1];
}

void DebugServer::takeJoined() {
  std::uint64_t count = 0;
  if (::read(joining_, &count, sizeof count) < 0) return;
  const std::lock_guard lock(mutex_);
  for (const int fd : joined_) {
    Client& client = add(fd);
    client.spoke = true;
    if (!client.ends) admit(client);
  }
  joined_.clear();
}

DebugServer::Client& DebugServer::add(int fd) {
  const bool hasRoom = clients_.size() < maxClients || makeRoom();
  Client& client = clients_.emplace_back();
  client.fd = fd;
  client.progress = Clock::now();
  if (!hasRoom) end(client, "too many clients: " + std::to_string(maxClients) + " are there");
  return client;
}

bool DebugServer::makeRoom() {
  // In the order in which they came.
  for (auto client = clients_.begin(); client != clients_.end(); ++client) {
    if (client->spoke || client->ends) continue;
    // It may have spoken since it was last listened to.
    receive(*client);
    takeLines(*client);
    if (client->spoke || client->ends) continue;
    end(*client, "you have said nothing, and other clients need the place");
    send(*client);
    close(*client);
    clients_.erase(client);
    return true;
  }
  return false;
}

void DebugServer::accept() {
  for (int taken = 0; taken < clientsAtOnce; ++taken) {
    const int fd = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (fd < 0) return;
    const int on = 1;
    setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
    Client& client = add(fd);
    if (!client.ends && token_.empty()) admit(client);
  }
}

void DebugServer::admit(Client& client) {
  // A list: the address stays.
  client.inspected = inspector_.open(
      [this, &client](std::string_view line, bool droppable) { return append(client, line, droppable); });
}

bool DebugServer::append(Client& client, std::string_view line, bool droppable) {
  if (client.ends || client.dead) return false;
  if (client.out.empty()) client.progress = Clock::now();
  const std::size_t waiting = client.out.size() - client.sent;
  if (droppable && waiting > dropsFrom) {
    ++client.dropped;
    return false;
  }
  if (client.dropped > 0 && waiting < dropsFrom) {
    client.out += "error: at least " + std::to_string(client.dropped) +
                  " lines were left out: the client reads too slowly\n";
    client.dropped = 0;
  }
  if (waiting + line.size() > maxWaiting) {
    client.dead = true;
    return false;
  }
  client.out += line;
  client.out += '\n';
  return true;
}

void DebugServer::end(Client& client, const std::string& error) {
  append(client, "error: " + error, false);
  client.ends = true;
  client.in.clear();
}

void DebugServer::takeLine(Client& client, std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (client.inspected >= 0) {
    client.spoke = true;
    return inspector_.command(client.inspected, line);
  }
  if (!sameSecret(line, token_)) return end(client, "the first line must be the token");
  client.spoke = true;
  admit(client);
}

void DebugServer::takeLines(Client& client) {
  std::size_t begin = 0;
  for (int lines = 0; lines < linesAtOnce && !client.ends; ++lines) {
    const auto stop = client.in.find('\n', begin);
    if (stop == std::string::npos) break;
    takeLine(client, std::string_view(client.in).substr(begin, stop - begin));
    begin = stop + 1;
  }
  if (client.ends) return;
  client.in.erase(0, begin);
  if (client.in.size() > maxLine && client.in.find('\n') == std::string::npos)
    end(client, "a line is longer than " + std::to_string(maxLine) + " bytes");
}

void DebugServer::receive(Client& client) {
  char buffer[16384];
  if (client.in.size() > maxLine) return;  // lines wait for their turn
  const ssize_t got = recv(client.fd, buffer, sizeof(buffer), 0);
  if (got == 0) client.dead = client.out.empty();
  if (got == 0) client.ends = true;
  if (got < 0 && errno != EAGAIN && errno != EINTR) client.dead = true;
  if (got > 0 && !client.ends) client.in.append(buffer, static_cast<std::size_t>(got));
}

void DebugServer::send(Client& client) {
  while (client.sent < client.out.size()) {
    const ssize_t done = ::send(client.fd, client.out.data() + client.sent, client.out.size() - client.sent,
                                MSG_NOSIGNAL | MSG_DONTWAIT);
    if (done < 0 && errno != EAGAIN && errno != EINTR) client.dead = true;
    if (done <= 0) break;
    client.sent += static_cast<std::size_t>(done);
    client.progress = Clock::now();
  }
  if (client.sent == client.out.size() || client.sent > dropsFrom) {
    client.out.erase(0, client.sent);
    client.sent = 0;
  }
  if (client.ends && client.out.empty()) client.dead = true;
}

void DebugServer::close(const Client& client) {
  if (client.inspected >= 0) inspector_.close(client.inspected);
  ::close(client.fd);
}

void DebugServer::sweep() {
  const auto now = Clock::now();
  for (auto at = clients_.begin(); at != clients_.end();) {
    const bool waits = !at->out.empty() || (at->inspected < 0 && !token_.empty());
    const bool stalled = waits && std::chrono::duration<double>(now - at->progress).count() > patience;
    if (!at->dead && !stalled) {
      ++at;
      continue;
    }
    close(*at);
    at = clients_.erase(at);
  }
}

void DebugServer::serve(int stopDescriptor) {
  std::vector<pollfd> descriptors;
  for (;;) {
    descriptors.assign({{stopDescriptor, POLLIN, 0}, {listener_, POLLIN, 0}, {joining_, POLLIN, 0}});
    bool lines = false;
    for (const Client& client : clients_) {
      const bool full = client.in.size() > maxLine;
      lines = lines || client.in.find('\n') != std::string::npos;
      const int wanted = (full ? 0 : POLLIN) | (client.out.empty() ? 0 : POLLOUT);
      descriptors.push_back({client.fd, static_cast<short>(wanted), 0});
    }
    const int wait = lines ? 0 : inspector_.busy() ? busyWait : idleWait;
    if (::poll(descriptors.data(), descriptors.size(), wait) < 0 && errno != EINTR) return;
    if (descriptors[0].revents != 0) return;
    std::size_t index = 3;
    for (Client& client : clients_) {
      if ((descriptors[index++].revents & (POLLIN | POLLHUP | POLLERR)) != 0) receive(client);
      takeLines(client);
    }
    inspector_.poll();
    for (Client& client : clients_) send(client);
    if ((descriptors[1].revents & POLLIN) != 0) accept();
    if (descriptors[2].revents != 0) takeJoined();
    sweep();
  }
}

}  // namespace plumbline::inspect
