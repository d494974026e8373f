#include "tunnel/ServerRank.h"

#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "optimization/farm/LineSocket.h"

namespace plumbline::tunnel {
namespace {

constexpr double drain = 1, lastWords = 3, byeWithin = 1;  // [s]

/// A port that no program uses now. The server opens it soon after, and ends with an error if another program
/// was quicker.
int freePort() {
  int port = 0;
  ::close(farm::listenOn("127.0.0.1", 0, port));
  return port;
}

}  // namespace

ServerRank::ServerRank(RankTransport& transport, const TunnelOptions& given)
    : TunnelRank(transport, given),
      port_(given.port != 0 ? given.port : freePort()),
      command_(given.server, port_, 0) {
  for (int rank = 1; rank < transport.ranks(); ++rank)
    workers_.emplace_back([this, rank](const Frame& frame) { send(rank, frame); })
        .link.connectTo(port_, options.patience);
}

void ServerRank::watch(std::vector<pollfd>& watched) {
  for (Worker& one : workers_) one.link.watch(watched);
}

void ServerRank::serve(std::span<const pollfd> watched, double now) {
  for (Worker& one : workers_) watched = watched.subspan(one.link.serve(watched, now));
}

void ServerRank::take(int from, const Frame& frame, double now) {
  Worker& one = workers_.at(static_cast<std::size_t>(from) - 1);
  if (frame.connection != 0)
    one.link.take(frame, now);
  else if (frame.kind == FrameKind::ended)
    one.status = static_cast<int>(frame.value);
  else if (frame.kind == FrameKind::bye && overAt_ >= 0)
    one.left = true;
  else
    throw std::invalid_argument("a frame that is not a worker's to send");
}

void ServerRank::checkWorkers() const {
  if (std::ranges::all_of(workers_, [](const Worker& one) { return one.status > 0; }))
    throw std::runtime_error("the commands of all workers have failed, the last one with status " +
                             std::to_string(workers_.back().status));
}

int ServerRank::step(double now) {
  if (status_ < 0) {
    checkWorkers();
    const std::optional<int> status = command_.status();
    if (!status) return -1;
    status_ = *status;
    endedAt_ = now;
  }
  if (overAt_ < 0) {
    const bool quiet = std::ranges::all_of(workers_, [](const Worker& one) { return one.link.quiet(); });
    if (!quiet && now - endedAt_ < drain) return -1;
    sendAll({FrameKind::over, 0, static_cast<std::uint32_t>(status_)});
    overAt_ = now;
  }
  const bool allLeft = std::ranges::all_of(workers_, [](const Worker& one) { return one.left; });
  if (byeAt_ < 0) {
    if (!allLeft && now - overAt_ <= options.grace + lastWords) return -1;
    sendAll({FrameKind::bye});
    byeAt_ = now;
  }
  return sentAll() || now - byeAt_ > byeWithin ? status_ : -1;
}

}  // namespace plumbline::tunnel
