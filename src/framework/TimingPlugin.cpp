#include "framework/TimingPlugin.h"

#include <ctime>

namespace plumbline {
namespace {

std::uint64_t threadCpu() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<std::uint64_t>(time.tv_sec) * 1000000000 + static_cast<std::uint64_t>(time.tv_nsec);
}

}  // namespace

TimingPlugin::TimingPlugin(const ThreadInfo& thread) : thread_(thread.name) {
  for (const Step& step : thread.steps) steps_.push_back({step.label, std::make_unique<Stopwatch>()});
}

void TimingPlugin::threadStarted(const ThreadInfo&) { cpuBefore_ = threadCpu(); }

void TimingPlugin::cycleFinished(const Duration& duration) {
  cycle_.add(nanoseconds(duration));
  const std::uint64_t now = threadCpu();
  cpu_.add(now - cpuBefore_);
  cpuBefore_ = now;
}

}  // namespace plumbline
