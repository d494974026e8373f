#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "framework/Plugin.h"
#include "framework/StepTimes.h"
#include "framework/Stopwatch.h"
#include "framework/Waiting.h"

namespace plumbline {

/// Stopwatches around every step and cycle of a thread; read by anybody at any time. Those of steps are up to
/// half a second or 64 cycles behind, except in the first 64 cycles and after flush().
class TimingPlugin final : public Plugin {
public:
  struct Entry {
    std::string name;  ///< the step's label
    std::string module;
    std::shared_ptr<Stopwatch> stopwatch;
    std::atomic<std::uint64_t> overruns{0};  ///< cycles that ran over and in which this took longest
    std::atomic<std::uint64_t> waited{0};    ///< since the start [ns]
  };

  explicit TimingPlugin(const ThreadInfo& thread);
  void threadStarted(const ThreadInfo&) override;
  void threadStopped() override { flush(); }
  void afterExecute(const Step& step, const Duration& duration) override { add(step, duration); }
  void afterUpdate(const Step& step, const Duration& duration) override { add(step, duration); }
  void cycleFinished(const Duration& duration) override;
  /// Brings the stopwatches of the steps up to date; on the thread itself, between its cycles.
  void flush();

  const std::string& thread() const { return thread_; }
  const std::deque<Entry>& steps() const { return steps_; }
  /// From the beginning to the end of a cycle; includes waiting for input.
  const Stopwatch& cycle() const { return *cycle_; }
  /// The thread's processor time from the end of one cycle to the end of the next.
  const Stopwatch& cpu() const { return *cpu_; }
  /// From the beginning to the end of a cycle without what modules waited (Waiting).
  const Stopwatch& busy() const { return *busy_; }
  /// The three by name, for those who keep them longer than the thread lasts.
  std::array<std::pair<const char*, std::shared_ptr<const Stopwatch>>, 3> ofThread() const {
    return {{{"cycle", cycle_}, {"busy", busy_}, {"processor", cpu_}}};
  }
  /// busy() as part of the time that has passed since the first cycle, 0 to 1.
  double load() const;
  /// Cycles per second that modules.cfg states; 0: none.
  double rate() const { return rate_; }
  /// Cycles that were busy for longer, or took more processor time, than deadline(), without the first one,
  /// in which modules get ready. While programs wait for each other in step, only processor time says who is
  /// slow.
  std::uint64_t lateBusy() const { return lateBusy_.load(std::memory_order_relaxed); }
  std::uint64_t lateCpu() const { return lateCpu_.load(std::memory_order_relaxed); }
  /// Processor time of the first cycle, and the largest of the others [s].
  double firstCpu() const { return 1e-9 * static_cast<double>(firstCpu_.load()); }
  double largestCpu() const { return 1e-9 * static_cast<double>(largestCpu_.load()); }
  /// The length of a cycle at the thread's rate; without a rate, at the league's 50 Hz [s].
  double deadline() const { return rate_ > 0 ? 1 / rate_ : 0.02; }
  /// Cycles that were busy for longer than the rate allows.
  std::uint64_t overruns() const { return overruns_.load(std::memory_order_relaxed); }

private:
  void add(const Step& step, const Duration& duration) {
    const std::uint64_t taken = nanoseconds(duration);
    times_.put(step.index, taken);
    if (const std::uint64_t waited = std::min(Waiting::take(), taken); waited > 0)
      addWait(step.index, waited);
  }
  void countLate(std::uint64_t busy, std::uint64_t cpu);
  void addWait(std::size_t step, std::uint64_t waited);
  /// The step that worked longest in this cycle.
  std::size_t longest() const;
  static std::uint64_t nanoseconds(const Duration& duration) {
    return static_cast<std::uint64_t>(std::chrono::nanoseconds(duration.end - duration.begin).count());
  }

  std::string thread_;
  double rate_;
  std::deque<Entry> steps_;
  StepTimes times_;
  std::vector<std::pair<std::size_t, std::uint64_t>> waits_;  ///< in this cycle: step, and how long [ns]
  std::shared_ptr<Stopwatch> cycle_ = std::make_shared<Stopwatch>(), cpu_ = std::make_shared<Stopwatch>(),
                             busy_ = std::make_shared<Stopwatch>();
  std::atomic<std::uint64_t> lateBusy_{0}, lateCpu_{0}, firstCpu_{0}, largestCpu_{0}, overruns_{0}, first_{0},
      last_{0};
  std::uint64_t cpuBefore_ = 0;
  std::uint64_t waited_ = 0;  ///< in this cycle [ns]
};

}  // namespace plumbline
