#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/ModuleGraph.h"
#include "framework/Plugin.h"
#include "framework/SpecialModule.h"
#include "framework/ThreadCopy.h"
#include "framework/TimingPlugin.h"

namespace plumbline {

class CrashRecord;

/// One thread of an agent: its representations, its modules in their order, and the cycle over them. Runs
/// in whatever thread calls it.
class Process {
public:
  /// Makes representations and modules; they are connected by bind().
  Process(const ThreadPlan& plan, ConfigStore& config, ModuleObjects& objects, StopSignal& stop);
  ~Process();

  /// What this thread publishes to, or fetches from, another one. Both before start().
  void addPublished(ThreadCopy& copy) { published_.push_back(&copy); }
  void addFetched(ThreadCopy& copy) { fetched_.push_back(&copy); }

  /// Gives the modules their pointers and calls init() of each, in their order. Errors as in cycle().
  void init();
  /// On the thread that calls cycle(), around all cycles; a second call of either does nothing.
  void start();
  void finish();
  /// One cycle. Whatever a module throws comes out as std::runtime_error naming the step; a
  /// ConfigurationError as it is.
  void cycle();

  const std::string& name() const { return info_.name; }
  int priority() const { return info_.priority; }
  /// A representation provided in this thread, or null.
  Representation* find(const std::string& representation) const;
  const TimingPlugin& timing() const { return *timing_; }
  const ThreadInfo& info() const { return info_; }

private:
  void offerToSpecials();
  void runSteps(Plugin::Clock::time_point now);

  ThreadPlan plan_;
  ThreadInfo info_;
  std::map<std::string, std::unique_ptr<RepresentationHolder>> representations_;
  std::vector<std::unique_ptr<Module>> modules_;
  std::vector<std::unique_ptr<SpecialModule>> specials_;
  std::vector<ThreadCopy*> published_, fetched_;
  std::vector<std::unique_ptr<Plugin>> plugins_;
  std::unique_ptr<TimingPlugin> timing_;
  std::vector<std::uint32_t> crashSteps_;
  int crashThread_ = -1;
  bool running_ = false;
  CrashRecord* record_ = nullptr;
  const Step* current_ = nullptr;
};

}  // namespace plumbline
