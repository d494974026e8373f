#include "framework/TimingPlugin.h"

#include <ctime>

namespace plumbline {
namespace {

std::uint64_t threadCpu() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<std::uint64_t>(time.tv_sec) * 1000000000 + static_cast<std::uint64_t>(time.tv_nsec);
}

std::uint64_t nanosecondsOf(Plugin::Clock::time_point time) {
  return static_cast<std::uint64_t>(std::chrono::nanoseconds(time.time_since_epoch()).count());
}

}  // namespace

TimingPlugin::TimingPlugin(const ThreadInfo& thread) : thread_(thread.name), rate_(thread.rate) {
  for (const Step& step : thread.steps) {
    Entry& entry = steps_.emplace_back();
    entry.name = step.label;
    entry.module = step.module;
    entry.stopwatch = std::make_shared<Stopwatch>();
  }
}

void TimingPlugin::threadStarted(const ThreadInfo&) {
  cpuBefore_ = threadCpu();
  Waiting::take();
}

void TimingPlugin::cycleFinished(const Duration& duration) {
  const std::uint64_t taken = nanoseconds(duration);
  cycle_->add(taken);
  const std::uint64_t busy = taken - std::min(waited_, taken);
  waited_ = 0;
  busy_->add(busy);
  if (first_.load(std::memory_order_relaxed) == 0) first_.store(nanosecondsOf(duration.begin));
  last_.store(nanosecondsOf(duration.end), std::memory_order_relaxed);
  if (rate_ > 0 && 1e-9 * static_cast<double>(busy) * rate_ > 1) {
    overruns_.fetch_add(1, std::memory_order_relaxed);
    const auto longest = std::max_element(steps_.begin(), steps_.end(),
                                          [](const Entry& a, const Entry& b) { return a.worked < b.worked; });
    if (longest != steps_.end()) longest->overruns.fetch_add(1, std::memory_order_relaxed);
  }
  const std::uint64_t now = threadCpu();
  cpu_->add(now - cpuBefore_);
  cpuBefore_ = now;
}

double TimingPlugin::load() const {
  const auto passed = static_cast<double>(last_.load() - first_.load());
  return passed > 0 ? std::min(1.0, 1e9 * busy_->total() / passed) : 0;
}

}  // namespace plumbline
