#include "tunnel/Watchdog.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>

namespace plumbline::tunnel {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double look = 0.05, mostOfALook = 0.1;  // [s]

[[noreturn]] void endWithout(const char* why, int status) {
  std::fprintf(stderr, "mpitunnel: %s\n", why);
  _exit(status);
}

}  // namespace

Watchdog::Watchdog(const StopSignal& stop, double silence) {
  // Signals are for the thread that waits for sockets.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this, &stop, silence] { watch(stop, silence); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Watchdog::watch(const StopSignal& stop, double silence) {
  const pid_t parent = getppid();
  unsigned seen = beats_.load();
  bool announced = false;
  double stuck = 0, ends = 0;  // for so long [s]
  Clock::time_point last = Clock::now();
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::duration<double>(look), [this] { return done_; })) {
    const Clock::time_point now = Clock::now();
    const double step = std::min(std::chrono::duration<double>(now - last).count(), mostOfALook);
    last = now;
    const unsigned beats = beats_.load();
    stuck = beats == seen ? stuck + step : 0;
    // A loop that goes on after SIGCONT decides itself what that meant.
    announced = (announced && beats == seen) || continued_.came();
    seen = beats;
    const int status = status_.load();
    ends = status >= 0 || stop.requested() || announced || getppid() != parent ? ends + step : 0;
    if (ends > patience)
      endWithout("MPI does not let this rank go: it ends without", status >= 0 ? status : stopped);
    if (stuck > silence)
      endWithout("this rank has stood still for too long: MPI may wait for one that has gone", failed);
  }
}

}  // namespace plumbline::tunnel
