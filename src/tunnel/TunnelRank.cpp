#include "tunnel/TunnelRank.h"

#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "framework/SteadyClock.h"

namespace plumbline::tunnel {
namespace {

constexpr double sayEvery = 0.2;       // that this rank is there [s]
constexpr double longestStep = 0.1;    // what a pause of this rank's own counts as silence of others [s]
constexpr double killAfter = 0.4;      // patience with a child that ignores SIGTERM [s]
constexpr double stoppedFor = 0.05;    // at least, who was stopped [s]
constexpr double farewell = 0.05;      // for last messages [s]
constexpr int messagesAtOnce = 64;     // then sockets have their turn
constexpr int spins = 20, naps = 500;  // looks without a pause, then with the shorter one
constexpr int napMilliseconds = 1, restMilliseconds = 4;

std::string nameOf(int rank) { return "rank " + std::to_string(rank); }

}  // namespace

TunnelRank::TunnelRank(RankTransport& transport, const TunnelOptions& given)
    : options(given),
      transport_(transport),
      of_(static_cast<std::size_t>(transport.ranks())),
      parent_(getppid()) {}

void TunnelRank::send(int to, const Frame& frame) { transport_.send(to, encodeFrame(frame)); }

void TunnelRank::sendAll(const Frame& frame) {
  if (transport_.rank() != 0) return send(0, frame);
  for (int to = 1; to < transport_.ranks(); ++to) send(to, frame);
}

void TunnelRank::refuse(int from, const std::string& why) const {
  throw std::runtime_error(nameOf(from) + " sent " + why);
}

RankEnd TunnelRank::run(const StopSignal& stop) {
  Watchdog watchdog(stop, options.silence);
  try {
    command().start();
    return loop(stop, watchdog);
  } catch (...) {
    endEarly(Watchdog::failed, watchdog);
    throw;
  }
}

void TunnelRank::endEarly(int status, Watchdog& watchdog) {
  watchdog.ending(status);
  command().terminate();
  try {
    sendAll({FrameKind::stop, 0, static_cast<std::uint32_t>(status)});
    pass(farewell);
  } catch (const std::runtime_error&) {  // the first error is reported
  }
  command().stop(killAfter);
}

RankEnd TunnelRank::loop(const StopSignal& stop, Watchdog& watchdog) {
  for (;;) {
    watchdog.beat();
    watched_.assign(1, {stop.fileDescriptor(), POLLIN, 0});
    watch(watched_);
    // MPI has nothing that poll() could wait for: the longer nothing comes, the longer the pauses.
    const int pause = idle_ < spins ? 0 : idle_ < naps ? napMilliseconds : restMilliseconds;
    const bool ready = poll(watched_.data(), watched_.size(), pause) > 0;
    if (isEnding(stop)) {
      const int status = othersStatus_ >= 0 ? othersStatus_ : Watchdog::stopped;
      endEarly(status, watchdog);
      return {status, true};
    }
    const double now = steadySeconds();
    serve(std::span(watched_).subspan(1), now);
    const bool heard = takeMessages(now);
    idle_ = ready || heard ? 0 : idle_ + 1;
    watchOthers(now);
    if (const int status = step(now); status >= 0) return {status, false};
  }
}

bool TunnelRank::isEnding(const StopSignal& stop) {
  // Taken before and after: a stop between two of these lines is seen as one, too.
  const double begin = steadySeconds(), before = checked_;
  const bool came = continued_.came();
  checked_ = begin;
  // To be continued without having been stopped is what mpirun's ending begins with. It gives no second more.
  const bool announced = came && before >= 0 && steadySeconds() - before < stoppedFor;
  // Who is started by mpirun or srun ends with it.
  return stop.requested() || othersStatus_ >= 0 || announced || getppid() != parent_;
}

bool TunnelRank::takeMessages(double now) {
  int from = 0;
  std::string message;
  bool heard = false;
  for (int i = 0; i < messagesAtOnce && transport_.receive(from, message); ++i) {
    Frame frame;
    try {
      frame = decodeFrame(message);
      of_.at(static_cast<std::size_t>(from)).silent = 0;
      of_[static_cast<std::size_t>(from)].watched = frame.kind != FrameKind::bye;
      if (frame.kind == FrameKind::stop)
        othersStatus_ = static_cast<int>(frame.value);
      else if (frame.kind != FrameKind::alive)
        take(from, frame, now);
    } catch (const std::logic_error& error) {
      refuse(from, error.what());
    }
    heard = heard || frame.kind != FrameKind::alive;
  }
  return heard;
}

void TunnelRank::watchOthers(double now) {
  // A job that was suspended as a whole has not been silent.
  const double step = looked_ < 0 ? 0 : std::min(now - looked_, longestStep);
  looked_ = now;
  for (std::size_t i = 0; i < of_.size(); ++i) {
    if (!of_[i].watched) continue;
    of_[i].silent += step;
    if (of_[i].silent > options.silence)
      throw std::runtime_error(nameOf(static_cast<int>(i)) + " has gone: nothing came from it for " +
                               std::to_string(static_cast<int>(options.silence)) + " s");
  }
  if (now - said_ < sayEvery) return;
  said_ = now;
  sendAll({FrameKind::alive});
}

void TunnelRank::pass(double most) {
  int from = 0;
  std::string message;
  for (const double until = steadySeconds() + most; !transport_.sentAll() && steadySeconds() < until;)
    if (!transport_.receive(from, message)) usleep(1000);
}

}  // namespace plumbline::tunnel
