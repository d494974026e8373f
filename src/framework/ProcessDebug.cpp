#include "framework/ProcessDebug.h"

#include <algorithm>

#include "framework/ConfigurationError.h"
#include "framework/DebugSite.h"
#include "framework/ModuleParameters.h"

namespace plumbline {
namespace {

class RepresentationValue final : public DebugValue {
public:
  explicit RepresentationValue(Representation& value) : value_(value) {}
  void write(OutStream& out) const override { StreamType<Representation>::write(out, value_); }
  bool writable() const override { return true; }
  void read(InStream& in) override { StreamType<Representation>::read(in, value_); }

private:
  Representation& value_;
};

/// A parameter of a module. What it is set to goes the way of a configuration file's values.
class ParameterOfModule final : public DebugValue {
public:
  ParameterOfModule(Module& module, const ModuleDescription& description, const std::string& path,
                    std::map<std::string, ParameterValue>& set)
      : module_(module), description_(description), path_(path), set_(set) {}

  void write(OutStream& out) const override {
    visit([&](auto* value) { StreamType<std::remove_pointer_t<decltype(value)>>::write(out, *value); });
  }
  bool writable() const override { return true; }
  void read(InStream& in) override {
    visit([&](auto* value) {
      auto wanted = *value;
      StreamType<decltype(wanted)>::read(in, wanted);
      if (!in.ok()) return;
      try {
        setModuleParameter(module_, description_, path_, textOf(wanted));
        set_.insert_or_assign(path_, parameterValue(value));
      } catch (const ConfigurationError& error) {
        in.fail(error.what());
      }
    });
  }

private:
  template <typename T>
  static std::string textOf(T& value) {
    return parameterText(ParameterPointer(&value));
  }
  template <typename F>
  void visit(F&& function) const {
    description_.parameters.visit(
        &module_, [&](const std::string& path, const Parameter&, const ParameterPointer& pointer) {
          if (path == path_) std::visit(function, pointer);
        });
  }

  Module& module_;
  const ModuleDescription& description_;
  const std::string& path_;
  std::map<std::string, ParameterValue>& set_;
};

}  // namespace

ProcessDebug::ProcessDebug(AgentDebug& agent, const ThreadPlan& plan, const ThreadInfo& info,
                           const std::vector<std::unique_ptr<Module>>& modules, const TimingPlugin& timing)
    : agent_(agent), plan_(plan), modules_(modules), timing_(timing), stopwatchesOf_(modules.size()), set_(modules.size()) {
  for (const Step& step : info.steps) {
    ofStep_.push_back(nullptr);
    if (step.isExecute()) continue;
    values_.emplace_back("representation:" + step.representation);
    ofStep_.back() = &values_.back().point;
    agent_.points.add(values_.back().point);
  }
  for (std::size_t i = 0; i < plan.modules.size(); i++) {
    const ModuleDescription& description = plan.modules[i].loader->description();
    description.parameters.visit(modules[i].get(), [&](const std::string& path, const Parameter& parameter,
                                                       const ParameterPointer& pointer) {
      parameters_.emplace_back("config:" + description.name + "." + path, i, path);
      agent_.points.add(parameters_.back().point);
      agent_.addParameter(parameters_.back().id, {&parameter, parameterType(pointer)});
    });
  }
  for (const TimingPlugin::Entry& entry : timing.steps()) {
    stopwatches_.push_back("timing:" + entry.name);
    agent_.addStopwatch(stopwatches_.back(), entry.stopwatch);
  }
  agent_.addThread(plan_, timing_);
}

ProcessDebug::~ProcessDebug() {
  agent_.removeThread(timing_, stopwatches_);
  for (ValuePoint& value : values_) agent_.points.remove(value.point);
  for (ParameterPoint& parameter : parameters_) agent_.points.remove(parameter.point);
}

void ProcessDebug::addStopwatches() {
  for (std::size_t i = 0; i < modules_.size(); i++) {
    const auto& stopwatches = modules_[i]->debugStopwatches();
    if (stopwatches.size() == stopwatchesOf_[i]) continue;
    bool all = true;
    for (const auto& [name, stopwatch] : stopwatches) {
      const std::string id = "timing:" + plan_.modules[i].loader->description().name + ":" + name;
      all = agent_.tryAddStopwatch(id, stopwatch) && all;
      if (std::find(stopwatches_.begin(), stopwatches_.end(), id) == stopwatches_.end())
        stopwatches_.push_back(id);
    }
    if (all) stopwatchesOf_[i] = stopwatches.size();
  }
}

void ProcessDebug::beginCycle() {
  addStopwatches();
  for (ParameterPoint& parameter : parameters_) {
    if (!parameter.point.active()) continue;
    ParameterOfModule value(*modules_[parameter.module],
                            plan_.modules[parameter.module].loader->description(), parameter.path,
                            set_[parameter.module]);
    parameter.point.pass(value);
  }
}

void ProcessDebug::beginValues() {
  for (ValuePoint& value : values_) {
    if (!value.special || !value.point.active()) continue;
    RepresentationValue special(*value.special);
    value.point.pass(special);
  }
}

void ProcessDebug::addValue(const RepresentationLoader& loader, Representation& value) {
  values_.emplace_back("representation:" + loader.name());
  values_.back().special = &value;
  agent_.points.add(values_.back().point);
}

void ProcessDebug::lookAround(const ThreadInfo& info) {
  beginValues();
  for (const Step& step : info.steps) updated(step);
}

void ProcessDebug::setAgain(std::size_t index, Module& next) const {
  const auto& set = set_[index];
  if (set.empty()) return;
  plan_.modules[index].loader->description().parameters.visit(
      &next, [&](const std::string& path, const Parameter&, const ParameterPointer& pointer) {
        if (const auto found = set.find(path); found != set.end()) setParameterValue(pointer, found->second);
      });
  next.parametersChanged();
}

void ProcessDebug::updated(const Step& step) {
  DebugPoint* point = ofStep_[step.index];
  if (!point || !point->active()) return;
  RepresentationValue value(*step.value);
  point->pass(value);
}

}  // namespace plumbline
