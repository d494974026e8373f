#include "framework/StopSignal.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <stdexcept>

#include "framework/CrashLog.h"

namespace plumbline {
namespace {

using Clock = std::chrono::steady_clock;

/// `timeout` sends its signal to its child and to the child's group, so that one wish arrives twice.
constexpr auto oneWish = std::chrono::milliseconds(300);

std::atomic<StopSignal*> signalTarget{nullptr};
std::atomic<Clock::rep> caughtAt{0};
static_assert(std::atomic<Clock::rep>::is_always_lock_free, "a signal handler stores it");

/// Whoever starts a program by `nohup` wants it to go on when the terminal closes. SIGINT is another matter:
/// shell scripts have all they start in the background ignore it.
bool survives(int signal) {
  struct sigaction now {};
  return signal == SIGHUP && sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

StopSignal::StopSignal() : descriptor_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (descriptor_ < 0) throw std::runtime_error("no file descriptor left for the stop signal");
}

StopSignal::~StopSignal() {
  StopSignal* self = this;
  if (signalTarget.compare_exchange_strong(self, nullptr)) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
      if (!survives(signal)) std::signal(signal, SIG_DFL);
    caughtSignal = 0;
  }
  close(descriptor_);
}

void StopSignal::request(int exitCode, const std::string& reason) {
  {
    std::lock_guard lock(mutex_);
    // A caught signal has set requested_ without deciding; then it came first.
    if (decided_ || requested_.load()) return;
    decided_ = true;
    exitCode_ = exitCode;
    reason_ = reason;
  }
  requested_.store(true);
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(descriptor_, &one, sizeof(one));
}

int StopSignal::exitCode() const {
  std::lock_guard lock(mutex_);
  return exitCode_;
}

std::string StopSignal::reason() const {
  std::lock_guard lock(mutex_);
  if (decided_ || !requested_.load()) return reason_;
  switch (caughtSignal.load()) {
    case SIGINT:
      return "interrupted (SIGINT)";
    case SIGHUP:
      return "terminal closed (SIGHUP)";
    default:
      return "terminated (SIGTERM)";
  }
}

int StopSignal::caughtDescriptor() {
  const StopSignal* target = signalTarget.load();
  return target ? target->fileDescriptor() : -1;
}

void StopSignal::handle(int signal) {
  // Only what is allowed in a signal handler: atomics, the steady clock and write.
  StopSignal* target = signalTarget.load();
  const Clock::rep now = Clock::now().time_since_epoch().count();
  // First the time: another thread may get the second signal meanwhile.
  if (caughtSignal.load() == 0) caughtAt = now;
  int none = 0;
  const bool first = caughtSignal.compare_exchange_strong(none, signal);
  if (!target || (!first && Clock::duration(now - caughtAt) >= oneWish)) {
    CrashLog::giveUp();  // a person ends it
    std::signal(signal, SIG_DFL);
    raise(signal);
    return;
  }
  if (!first) return;
  target->requested_.store(true);
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(target->descriptor_, &one, sizeof(one));
}

void StopSignal::catchSignals() {
  caughtSignal = 0;
  signalTarget = this;
  struct sigaction action {};
  action.sa_handler = &StopSignal::handle;
  sigemptyset(&action.sa_mask);
  // No SA_RESTART: a module that waits in a system call is woken.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (!survives(signal)) sigaction(signal, &action, nullptr);
}

}  // namespace plumbline
