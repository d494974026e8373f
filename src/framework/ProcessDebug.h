#pragma once
#include <deque>
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

/// The debug points of one thread: `representation:NAME` behind each update, `config:MODULE.path` at the
/// beginning of a cycle; and its stopwatches as `timing:MODULE:step` and `timing:MODULE:name`.
class ProcessDebug {
public:
  /// All must outlive this; `modules` are those of `plan`, in its order, and may be made anew in between.
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
  /// Between cycles: all representations can be looked at as they are.
  void lookAround(const ThreadInfo& info);
  /// Gives a module that was made anew the parameters that were set while it ran.
  void setAgain(std::size_t module, Module& next) const;
  /// On the thread, or when it has ended: the modules' own stopwatches come with their first use.
  void addStopwatches();

private:
  struct ParameterPoint {
    std::string id;
    std::size_t module;
    std::string path;
    DebugPoint point;
    ParameterPoint(std::string id_, std::size_t module_, std::string path_)
        : id(std::move(id_)),
          module(module_),
          path(std::move(path_)),
          point(id.c_str(), DebugKind::parameter) {}
  };
  struct ValuePoint {
    std::string id;
    DebugPoint point;
    Representation* special = nullptr;  ///< provided by a special module
    explicit ValuePoint(std::string id_) : id(std::move(id_)), point(id.c_str(), DebugKind::modify) {}
  };

  AgentDebug& agent_;
  const ThreadPlan& plan_;
  const std::vector<std::unique_ptr<Module>>& modules_;
  const TimingPlugin& timing_;
  std::deque<ParameterPoint> parameters_;
  std::deque<ValuePoint> values_;
  std::vector<DebugPoint*> ofStep_;         ///< null: the step executes
  std::vector<std::size_t> stopwatchesOf_;  ///< of each module, as many as are known
  std::vector<std::string> stopwatches_;
  std::vector<std::map<std::string, ParameterValue>> set_;  ///< of each module while it ran, by path
};

}  // namespace plumbline
