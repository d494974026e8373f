#pragma once
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "framework/DebugPoints.h"
#include "framework/Stopwatch.h"

namespace plumbline {

class TimingPlugin;

/// What can be looked at in one agent: its representations and parameters as debug points, its stopwatches.
/// Every agent has one (ModuleObjects); filled by its threads.
class AgentDebug {
public:
  /// Representations and parameters.
  DebugPoints points;

  /// While nobody watches, threads do not look whether anything is wanted.
  bool watched() const { return watched_.load(std::memory_order_relaxed); }
  void setWatched(bool watched) { watched_.store(watched, std::memory_order_relaxed); }

  void addStopwatch(const std::string& id, std::shared_ptr<const Stopwatch> stopwatch);
  /// The same without waiting; false: not now.
  bool tryAddStopwatch(const std::string& id, std::shared_ptr<const Stopwatch> stopwatch);
  void addThread(const TimingPlugin& timing);
  /// Also forgets its stopwatches.
  void removeThread(const TimingPlugin& timing, const std::vector<std::string>& stopwatches);

  /// By id, "timing:Module:step".
  std::map<std::string, std::shared_ptr<const Stopwatch>> stopwatches() const;
  /// A table of the times of all threads up to now.
  std::string timingReport() const;

private:
  std::atomic<bool> watched_{false};
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const Stopwatch>> stopwatches_;
  std::vector<const TimingPlugin*> threads_;
};

}  // namespace plumbline
