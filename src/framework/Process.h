#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/ModuleGraph.h"
#include "framework/OutputGuard.h"
#include "framework/Plugin.h"
#include "framework/ProcessDebug.h"
#include "framework/SpecialModule.h"
#include "framework/ThreadCopy.h"
#include "framework/TimingPlugin.h"

namespace plumbline {

class CrashRecord;

/// One thread of an agent: its representations, its modules in their order, and the cycle over them. Runs
/// in whatever thread calls it. A module that provides a number that is not finite is replaced by a new one
/// at the end of the cycle, and what it provides keeps the last good value.
class Process {
public:
  /// Makes representations and modules; they are connected by bind().
  Process(const ThreadPlan& plan, ConfigStore& config, ModuleObjects& objects, StopSignal& stop,
          std::shared_ptr<AgentDebug> debug);
  ~Process();

  /// What this thread publishes to, or fetches from, another one. Both before start().
  void addPublished(ThreadCopy& copy) { published_.push_back(&copy); }
  void addFetched(ThreadCopy& copy) { fetched_.push_back(&copy); }

  /// Gives the modules their pointers and calls init() of each, in their order. Errors as in cycle().
  void init();
  /// On the thread that calls cycle(), around all cycles; a second call of either does nothing.
  void start();
  void finish();
  /// One cycle, unless a special module wants to wait or to start again. Exceptions of a module come out as
  /// std::runtime_error naming the step, a ConfigurationError as it is.
  void cycle();

  const std::string& name() const { return info_.name; }
  int priority() const { return info_.priority; }
  /// A representation provided in this thread, or null.
  Representation* find(const std::string& representation) const;
  const TimingPlugin& timing() const { return *timing_; }
  /// Brings timing() up to date; on the thread, between its cycles. finish() does it, too.
  void updateTiming() { timing_->flush(); }
  const ThreadInfo& info() const { return info_; }
  /// Has the modules' own stopwatches known; on the thread, or when it has ended.
  void addStopwatches() { debug_->addStopwatches(); }

private:
  void makeSpecials();
  void offerToSpecials();
  std::unique_ptr<Module> makeModule(std::size_t index);
  void connectModule(Module& module, std::size_t index);
  void initModule(Module& module, std::size_t index);
  void replaceModule(std::size_t index, std::unique_ptr<Module> next);
  void resetModule(std::size_t index);
  void reject(const Step& step, const std::string& problem);
  void remakeModules();
  void restart();
  bool reads(std::size_t index, const std::string& file) const;
  void takeParameters(std::size_t index, Module& from);
  std::string reload(const std::string& file);
  std::string remakeReaders(const std::string& file, const std::function<void()>& accept);
  void followReloads();
  void runCommands();
  bool takesTurn();
  void runSteps(Plugin::Clock::time_point now);

  ThreadPlan plan_;
  ThreadInfo info_;
  ConfigStore& config_;
  ModuleObjects& objects_;
  StopSignal& stop_;
  Log log_{"framework"};
  std::map<std::string, std::unique_ptr<RepresentationHolder>> representations_;
  std::vector<std::unique_ptr<Module>> modules_;
  std::vector<std::unique_ptr<SpecialModule>> specials_;
  std::vector<ThreadCopy*> published_, fetched_;
  std::vector<std::unique_ptr<Plugin>> plugins_;
  std::unique_ptr<TimingPlugin> timing_;
  std::shared_ptr<AgentDebug> agentDebug_;
  std::unique_ptr<ProcessDebug> debug_;
  bool debugging_ = false;                          ///< in this cycle
  bool unseen_ = false;                             ///< nobody looks into this cycle
  std::vector<std::optional<OutputGuard>> guards_;  ///< of each step; none: it executes
  std::vector<const Module*> rejected_;             ///< provided something that was not finite in this cycle
  std::vector<std::uint32_t> crashSteps_;
  int crashThread_ = -1;
  bool running_ = false;
  CrashRecord* record_ = nullptr;
  const Step* current_ = nullptr;
  std::uint64_t configVersion_ = 0;  ///< of the files that the modules have read
};

}  // namespace plumbline
