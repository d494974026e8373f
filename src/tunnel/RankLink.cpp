#include "tunnel/RankLink.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>

#include "optimization/farm/LineSocket.h"

namespace plumbline::tunnel {
namespace {

constexpr double tryEvery = 0.05;    // to connect [s]
constexpr double pauseAfter = 0.05;  // a connection that could not be accepted [s]

/// A socket that connects to loopback, or has; -1: refused.
int connectingSocket(int port, bool& connecting) {
  const int fd = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (fd < 0) return -1;
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_port = htons(static_cast<std::uint16_t>(port));
  where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int result = ::connect(fd, reinterpret_cast<const sockaddr*>(&where), sizeof where);
  connecting = result != 0;
  if (connecting ? errno == EINPROGRESS : !isItsOwnPeer(fd)) return fd;
  ::close(fd);
  return -1;
}

}  // namespace

RankLink::~RankLink() { stopListening(); }

void RankLink::stopListening() {
  if (listener_ >= 0) ::close(listener_);
  listener_ = -1;
}

int RankLink::listen() {
  listener_ = farm::listenOn("127.0.0.1", 0, port_);
  return port_;
}

void RankLink::connectTo(int port, double patience) {
  port_ = port;
  patience_ = patience;
  connects_ = true;
}

void RankLink::watch(std::vector<pollfd>& watched) {
  // Who comes when there are too many waits outside until one has gone.
  const bool accepts = listener_ >= 0 && !pauses_ && connections_.size() < maxConnections;
  watched.push_back({accepts ? listener_ : -1, POLLIN, 0});
  watched_.clear();
  for (const auto& [id, carried] : connections_) {
    const short events = carried.connection.events();
    watched.push_back({events != 0 ? carried.connection.descriptor() : -1, events, 0});
    watched_.push_back(id);
  }
}

std::size_t RankLink::serve(std::span<const pollfd> watched, double now) {
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    const auto place = connections_.find(watched_[i]);
    if (place == connections_.end()) continue;
    CarriedConnection& connection = place->second.connection;
    connection.serve(watched[i + 1].revents);
    gotThrough_ = gotThrough_ || connection.connected();
  }
  for (auto& [id, carried] : connections_)
    if (!carried.connection.hasSocket()) connect(carried, now);
  std::erase_if(connections_, [](const auto& one) { return one.second.connection.over(); });
  if (watched[0].revents != 0 && listener_ >= 0) accept(now);
  pauses_ = now < acceptAt_;
  const std::size_t count = watched_.size() + 1;
  watched_.clear();
  return count;
}

RankLink::Carried& RankLink::add(std::uint32_t id, double now) {
  last_ = id;
  return connections_.try_emplace(id, id, send_, now).first->second;
}

void RankLink::accept(double now) {
  while (connections_.size() < maxConnections) {
    const int fd = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (fd < 0) {
      // Too many files are open: who waits is seen again and again, and nothing changes that soon.
      if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM)
        acceptAt_ = now + pauseAfter;
      return;
    }
    if (last_ == UINT32_MAX) {  // never in practice; a number is never used twice
      ::close(fd);
      return;
    }
    Carried& carried = add(last_ + 1, now);
    send_({FrameKind::open, last_});
    carried.connection.use(fd);
  }
}

void RankLink::connect(Carried& carried, double now) {
  if (carried.connection.over() || now < carried.tryAt) return;
  if (carried.lastTry || (carried.tried && now - carried.since >= patience_))
    return carried.connection.reset();
  carried.tried = true;
  carried.lastTry = gotThrough_;  // the first that can succeed, where it waited for the server
  carried.tryAt = now + tryEvery;
  bool connecting = false;
  if (const int fd = connectingSocket(port_, connecting); fd >= 0) {
    carried.connection.use(fd, connecting);
    gotThrough_ = gotThrough_ || !connecting;
  }
}

void RankLink::take(const Frame& frame, double now) {
  const auto place = connections_.find(frame.connection);
  if (frame.kind == FrameKind::open) {
    if (!connects_) throw std::invalid_argument("a connection that begins at the wrong end");
    if (frame.connection != last_ + 1)
      throw std::invalid_argument("connection " + std::to_string(frame.connection) + " after connection " +
                                  std::to_string(last_));
    Carried& carried = add(frame.connection, now);
    // The other end has as many at most, but may have closed some that here have bytes left for the server.
    if (connections_.size() > maxConnections) carried.connection.reset();
    connect(carried, now);
  } else if (place != connections_.end()) {
    place->second.connection.take(frame);
    if (place->second.connection.over()) connections_.erase(place);
  } else if (frame.connection > last_) {
    throw std::invalid_argument("a frame of connection " + std::to_string(frame.connection) +
                                ", which nobody opened");
  }  // Else what was on its way when the connection ended here.
}

bool RankLink::quiet() const {
  return std::ranges::all_of(connections_, [](const auto& one) { return one.second.connection.quiet(); });
}

}  // namespace plumbline::tunnel
