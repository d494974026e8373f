#pragma once
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "framework/ConfigFile.h"
#include "framework/ModuleGraph.h"
#include "framework/ModuleObjects.h"
#include "framework/StopSignal.h"

namespace plumbline {

class AgentDebug;
class Process;
class ThreadCopy;
class TimingPlugin;

struct ControllerOptions {
  std::string modulesConfig = "modules.cfg";
  /// Where config files are looked for; later directories override values of earlier ones.
  std::vector<std::string> configDirectories = {"config"};
};

/// An agent: the threads of one modules.cfg. In order: the constructor reads modules.cfg and sorts the graph,
/// init() makes the modules, run() runs them until somebody requests the stop. The first two throw
/// ConfigurationError for errors that a user must correct.
class Controller {
public:
  explicit Controller(ControllerOptions options);
  /// From text instead of options.modulesConfig, which then only is its name in errors.
  Controller(ControllerOptions options, std::string_view modulesConfigText);
  /// From one that was read, and may have been changed.
  Controller(ControllerOptions options, const ModulesConfig& modules);
  ~Controller();
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  const std::vector<ThreadPlan>& threads() const { return plans_; }
  /// Objects for the modules (ModuleObjects); before init().
  ModuleObjects& objects() { return objects_; }
  StopSignal& stop() { return stop_; }

  /// Makes all modules and calls their init(); then checks that every key of every config file is known.
  /// Called by run() if need be.
  void init();
  /// Runs until the stop is requested and all threads have ended their cycle. One thread runs in the
  /// caller's. Returns the requested exit code. An exception of a module ends the agent: a ConfigurationError
  /// is thrown on, any other gives exit code 1 with the reason in stop().reason().
  int run();
  /// Runs that many cycles of the only thread, fewer if the stop is requested; may be called again. What a
  /// module throws comes out. For tests and tools. Returns how many were run.
  std::size_t runCycles(std::size_t count);

  /// A representation in a thread (the first if none is named), or null if it is not provided there. Not to
  /// be read while that thread runs.
  template <typename R>
  const R* find(const std::string& thread = "") const {
    return static_cast<const R*>(findRepresentation(R::representationName(), thread));
  }
  const Representation* findRepresentation(const std::string& name, const std::string& thread = "") const;

  /// The stopwatches of a thread (the first if none is named); null before init() or if there is no such
  /// thread.
  const TimingPlugin* timing(const std::string& thread = "") const;
  /// A table of all stopwatches; not while threads run.
  std::string timingReport() const;
  /// What can be looked at from outside, at any time.
  AgentDebug& debug() { return *debug_; }
  /// What each module cost [us per cycle], by name, once the threads have ended.
  std::map<std::string, double> moduleTimes() const;

private:
  void runProcess(Process& process);
  Process* process(const std::string& thread) const;

  ControllerOptions options_;
  StopSignal stop_;
  ModuleObjects objects_;
  std::shared_ptr<AgentDebug> debug_;
  ConfigStore config_;
  std::vector<ThreadPlan> plans_;
  std::vector<std::unique_ptr<ThreadCopy>> copies_;
  std::vector<std::unique_ptr<Process>> processes_;
  bool initialized_ = false;
  std::mutex errorMutex_;
  std::exception_ptr configurationError_;
};

}  // namespace plumbline
