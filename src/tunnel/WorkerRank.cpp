#include "tunnel/WorkerRank.h"

#include <cstdio>
#include <stdexcept>

namespace plumbline::tunnel {
namespace {

constexpr double pauseBeforeAgain = 1, lateKillAfter = 0.5;  // [s]

}  // namespace

WorkerRank::WorkerRank(RankTransport& transport, const TunnelOptions& given)
    : TunnelRank(transport, given),
      rank_(transport.rank()),
      link_([this](const Frame& frame) { send(0, frame); }),
      command_(given.worker, link_.listen(), rank_) {}

void WorkerRank::take(int from, const Frame& frame, double now) {
  if (from == 0 && frame.connection != 0) return link_.take(frame, now);
  if (from == 0 && frame.kind == FrameKind::bye && over_) {
    mayLeave_ = true;
    return;
  }
  if (from != 0 || frame.kind != FrameKind::over)
    throw std::invalid_argument("a frame that is not its to send");
  over_ = true;
  link_.stopListening();
  // A server that failed sends no end to its worker.
  endBy_ = now + (frame.value == 0 ? options.grace : 0);
}

void WorkerRank::hasEnded(int status, double now) {
  if (status != 0)
    std::fprintf(stderr, "mpitunnel: rank %d: %s ended with status %d%s\n", rank_, command_.name().c_str(),
                 status, options.again ? ", and is started again" : "");
  if (status != 0 && options.again)
    againAt_ = now + pauseBeforeAgain;
  else
    send(0, {FrameKind::ended, 0, static_cast<std::uint32_t>(status)});
}

int WorkerRank::step(double now) {
  if (const std::optional<int> status = command_.status(); status && !ended_) {
    ended_ = true;
    if (!over_) hasEnded(*status, now);
  }
  if (!over_) {
    if (againAt_ < 0 || now < againAt_) return -1;
    againAt_ = -1;
    ended_ = false;
    command_.start();
    return -1;
  }
  if (!saidBye_) {
    if (!ended_ && now < endBy_) return -1;
    command_.stop(lateKillAfter);
    send(0, {FrameKind::bye});
    saidBye_ = true;
  }
  // MPI's own farewell is one of all ranks: a rank that begins it alone waits there and reads no message.
  return mayLeave_ ? 0 : -1;
}

}  // namespace plumbline::tunnel
