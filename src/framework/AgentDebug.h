#pragma once
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "framework/DebugPoints.h"
#include "framework/GraphReport.h"
#include "framework/Stopwatch.h"
#include "parameters/Parameter.h"

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
  void addThread(const ThreadPlan& plan, const TimingPlugin& timing);
  /// Also forgets its stopwatches.
  void removeThread(const TimingPlugin& timing, const std::vector<std::string>& stopwatches);

  /// Who provides a representation in a thread: a module, another thread or a special module.
  struct Provision {
    std::string thread, representation, provider;
  };
  /// By thread, in its order.
  std::vector<Provision> provisions() const;

  /// By id, "timing:Module:step".
  std::map<std::string, std::shared_ptr<const Stopwatch>> stopwatches() const;
  /// What is known of a parameter and never changes, by id, "config:Module.path".
  struct ParameterInfo {
    const Parameter* parameter;
    std::string type;
  };
  void addParameter(const std::string& id, ParameterInfo info);
  std::map<std::string, ParameterInfo> parameters() const;
  /// The threads with their modules and what they took up to now.
  std::vector<ThreadReport> graph() const;
  /// A table of the times of all threads up to now.
  std::string timingReport() const;

private:
  std::atomic<bool> watched_{false};
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const Stopwatch>> stopwatches_;
  struct Thread {
    const ThreadPlan* plan;
    const TimingPlugin* timing;
  };
  std::vector<Thread> threads_;
  std::map<std::string, ParameterInfo> parameters_;
};

}  // namespace plumbline
