#pragma once
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/AgentDebug.h"
#include "framework/Module.h"
#include "framework/ModuleGraph.h"
#include "framework/Plugin.h"
#include "framework/TimingPlugin.h"

namespace plumbline {

/// The debug points of one thread: `representation:NAME` after each update, `config:MODULE.path` at the
/// beginning of a cycle; and its stopwatches as `timing:MODULE:step` and `timing:MODULE:name`.
class ProcessDebug {
public:
  /// All must outlive this; `modules` are those of `plan`, in its order, and may be replaced in between.
  ProcessDebug(AgentDebug& agent, const ThreadPlan& plan, const ThreadInfo& info,
               const std::vector<std::unique_ptr<Module>>& modules, const TimingPlugin& timing);
  ~ProcessDebug();
  ProcessDebug(const ProcessDebug&) = delete;
  ProcessDebug& operator=(const ProcessDebug&) = delete;

  /// False: nothing is wanted in this cycle, and nothing below need be called.
  bool wanted() const { return agent_.watched(); }
  void beginCycle();
  /// Behind what special modules do at the beginning of a cycle.
  void beginValues();
  void updated(const Step& step);
  /// A representation that a special module provides; it is looked at at the beginning of a cycle.
  void addValue(const RepresentationLoader& loader, Representation& value);
  /// Blocks that run on request at the end of a cycle: `reset:MODULE` for each module, `reload:FILE` for
  /// these.
  void addCommands(const std::vector<std::string>& files);
  /// Runs what is wanted; a function returns a line for who wanted it, or throws.
  void runCommands(const std::function<std::string(std::size_t)>& reset,
                   const std::function<std::string(const std::string&)>& reload);
  /// Between cycles: all representations can be looked at as they are.
  void lookAround(const ThreadInfo& info);
  /// Gives a new module, which was configured, the parameters that were set while the old one ran.
  void setAgain(std::size_t module, Module& next);
  /// That module, or its parameters, took the place of the old one's.
  void accepted(std::size_t module);
  /// On the thread, or when it has ended: the modules' own stopwatches come with their first use.
  void addStopwatches();

private:
  struct ParameterPoint {
    std::string id;
    std::size_t module;
    std::string path;
    DebugPoint point;
    ParameterPoint(std::string name, std::size_t ofModule, std::string place)
        : id(std::move(name)),
          module(ofModule),
          path(std::move(place)),
          point(id.c_str(), DebugKind::parameter) {}
  };
  struct ValuePoint {
    std::string id;
    DebugPoint point;
    const RepresentationLoader* loader;
    Representation* special = nullptr;  ///< provided by a special module
    explicit ValuePoint(const RepresentationLoader& of)
        : id("representation:" + of.name()), point(id.c_str(), DebugKind::modify), loader(&of) {}
  };

  struct Command {
    std::string id, file;
    std::size_t module;
    DebugPoint point;
    Command(const std::string& name, std::string place, std::size_t ofModule)
        : id(name), file(std::move(place)), module(ofModule), point(id.c_str(), DebugKind::codeOnce) {}
  };

  std::map<std::string, ParameterValue> valuesOf(std::size_t module, Module& from) const;

  AgentDebug& agent_;
  const ThreadPlan& plan_;
  const std::vector<std::unique_ptr<Module>>& modules_;
  const TimingPlugin& timing_;
  std::deque<ParameterPoint> parameters_;
  std::deque<ValuePoint> values_;
  std::deque<Command> commands_;
  std::vector<ValuePoint*> ofStep_;         ///< null: the step executes
  std::vector<std::size_t> stopwatchesOf_;  ///< of each module, as many as are known
  std::vector<std::string> stopwatches_;
  /// A module's parameters by path.
  struct Parameters {
    std::map<std::string, ParameterValue> configured,
        next;                                   ///< by its file; and by that of the module made last
    std::map<std::string, ParameterValue> set;  ///< to something else while it ran
  };
  std::vector<Parameters> ofModule_;
};

}  // namespace plumbline
