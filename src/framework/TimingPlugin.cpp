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

TimingPlugin::TimingPlugin(const ThreadInfo& thread)
    : thread_(thread.name), rate_(thread.rate), times_(thread.steps.size()) {
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

void TimingPlugin::addWait(std::size_t step, std::uint64_t waited) {
  std::atomic<std::uint64_t>& all = steps_[step].waited;
  all.store(all.load(std::memory_order_relaxed) + waited, std::memory_order_relaxed);
  waits_.emplace_back(step, waited);
  waited_ += waited;
}

std::size_t TimingPlugin::longest() const {
  std::vector<std::uint64_t> worked(steps_.size());
  for (std::size_t i = 0; i < worked.size(); ++i) worked[i] = times_.of(i);
  for (const auto& [step, waited] : waits_) worked[step] -= waited;
  return static_cast<std::size_t>(std::ranges::max_element(worked) - worked.begin());
}

void TimingPlugin::flush() {
  times_.empty([this](std::size_t step, std::uint64_t taken) { steps_[step].stopwatch->add(taken); });
}

void TimingPlugin::countLate(std::uint64_t busy, std::uint64_t cpu) {
  if (cpu_->count() == 1) {
    firstCpu_.store(cpu);
    return;
  }
  if (cpu > largestCpu_.load(std::memory_order_relaxed)) largestCpu_.store(cpu, std::memory_order_relaxed);
  const auto isLate = [&](std::uint64_t ns) { return 1e-9 * static_cast<double>(ns) > deadline(); };
  if (isLate(busy)) lateBusy_.fetch_add(1, std::memory_order_relaxed);
  if (isLate(cpu)) lateCpu_.fetch_add(1, std::memory_order_relaxed);
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
    if (!steps_.empty()) steps_[longest()].overruns.fetch_add(1, std::memory_order_relaxed);
  }
  waits_.clear();
  if (times_.next(duration.end)) flush();
  const std::uint64_t now = threadCpu();
  const std::uint64_t spent = now - cpuBefore_;
  cpu_->add(spent);
  countLate(busy, spent);
  cpuBefore_ = now;
}

double TimingPlugin::load() const {
  const auto passed = static_cast<double>(last_.load() - first_.load());
  return passed > 0 ? std::min(1.0, 1e9 * busy_->total() / passed) : 0;
}

}  // namespace plumbline
