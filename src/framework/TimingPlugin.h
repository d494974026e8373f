#pragma once
#include <memory>
#include <string>
#include <vector>

#include "framework/Plugin.h"
#include "framework/Stopwatch.h"

namespace plumbline {

/// Stopwatches around every step and cycle of a thread; read by anybody at any time.
class TimingPlugin final : public Plugin {
public:
  struct Entry {
    std::string name;  ///< the step's label
    std::unique_ptr<Stopwatch> stopwatch;
  };

  explicit TimingPlugin(const ThreadInfo& thread);
  void threadStarted(const ThreadInfo&) override;
  void afterExecute(const Step& step, const Duration& duration) override { add(step, duration); }
  void afterUpdate(const Step& step, const Duration& duration) override { add(step, duration); }
  void cycleFinished(const Duration& duration) override;

  const std::string& thread() const { return thread_; }
  const std::vector<Entry>& steps() const { return steps_; }
  /// From the beginning to the end of a cycle; includes waiting for input.
  const Stopwatch& cycle() const { return cycle_; }
  /// The thread's processor time from the end of one cycle to the end of the next.
  const Stopwatch& cpu() const { return cpu_; }

private:
  void add(const Step& step, const Duration& duration) {
    steps_[step.index].stopwatch->add(nanoseconds(duration));
  }
  static std::uint64_t nanoseconds(const Duration& duration) {
    return static_cast<std::uint64_t>(std::chrono::nanoseconds(duration.end - duration.begin).count());
  }

  std::string thread_;
  std::vector<Entry> steps_;
  Stopwatch cycle_, cpu_;
  std::uint64_t cpuBefore_ = 0;
};

}  // namespace plumbline
