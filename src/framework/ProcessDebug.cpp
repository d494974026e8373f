#include "framework/ProcessDebug.h"

#include <algorithm>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/DebugSite.h"
#include "framework/ModuleParameters.h"

namespace plumbline {
namespace {

class RepresentationValue final : public DebugValue {
public:
  RepresentationValue(const RepresentationLoader& loader, Representation& value)
      : loader_(loader), value_(value) {}
  void write(OutStream& out) const override { StreamType<Representation>::write(out, value_); }
  bool writable() const override { return true; }
  void read(InStream& in) override { StreamType<Representation>::read(in, value_); }
  std::string problem() const override { return loader_.problemOf(value_); }

private:
  const RepresentationLoader& loader_;
  Representation& value_;
};

/// A parameter of a module. What it is set to goes the way of a configuration file's values.
class ParameterOfModule final : public DebugValue {
public:
  ParameterOfModule(Module& module, const ModuleDescription& description, const std::string& path,
                    const std::map<std::string, ParameterValue>& configured,
                    std::map<std::string, ParameterValue>& set)
      : module_(module), description_(description), path_(path), configured_(configured), set_(set) {}

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
        // Back to what the file says: from now on the file counts again.
        if (configured_.at(path_) == set_.at(path_)) set_.erase(path_);
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
  const std::map<std::string, ParameterValue>& configured_;
  std::map<std::string, ParameterValue>& set_;
};

/// Of what a module of the plan provides.
const RepresentationLoader& loaderOf(const ThreadPlan& plan, const std::string& representation) {
  for (const ModulePlan& module : plan.modules)
    for (const ModuleOutput* output : module.outputs)
      if (output->representation->name() == representation) return *output->representation;
  throw std::logic_error("no module of the thread provides " + representation);
}

}  // namespace

ProcessDebug::ProcessDebug(AgentDebug& agent, const ThreadPlan& plan, const ThreadInfo& info,
                           const std::vector<std::unique_ptr<Module>>& modules, const TimingPlugin& timing)
    : agent_(agent),
      plan_(plan),
      modules_(modules),
      timing_(timing),
      stopwatchesOf_(modules.size()),
      ofModule_(modules.size()) {
  for (std::size_t i = 0; i < modules.size(); ++i) ofModule_[i].configured = valuesOf(i, *modules[i]);
  for (const Step& step : info.steps) {
    ofStep_.push_back(nullptr);
    if (step.isExecute()) continue;
    ofStep_.back() = &values_.emplace_back(loaderOf(plan, step.representation));
    agent_.points.add(values_.back().point);
  }
  for (std::size_t i = 0; i < plan.modules.size(); ++i) {
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
  // No module has the name of a thread.
  for (const auto& [name, stopwatch] : timing.ofThread()) {
    stopwatches_.push_back("timing:" + plan.name + ':' + name);
    agent_.addStopwatch(stopwatches_.back(), stopwatch);
  }
  agent_.addThread(plan_, timing_);
}

void ProcessDebug::addCommands(const std::vector<std::string>& files) {
  for (std::size_t i = 0; i < plan_.modules.size(); ++i)
    commands_.emplace_back("reset:" + plan_.modules[i].loader->description().name, "", i);
  for (const std::string& file : files) commands_.emplace_back("reload:" + file, file, 0);
  for (Command& command : commands_) agent_.points.add(command.point);
}

void ProcessDebug::runCommands(const std::function<std::string(std::size_t)>& reset,
                               const std::function<std::string(const std::string&)>& reload) {
  for (Command& command : commands_) {
    if (!command.point.active()) continue;
    const DebugPoint::Visit visit(command.point);
    if (!visit.run()) continue;
    try {
      visit.output(command.file.empty() ? reset(command.module) : reload(command.file));
    } catch (const std::exception& error) {
      visit.fail(error.what());
    }
  }
}

ProcessDebug::~ProcessDebug() {
  agent_.removeThread(timing_, stopwatches_);
  for (ValuePoint& value : values_) agent_.points.remove(value.point);
  for (ParameterPoint& parameter : parameters_) agent_.points.remove(parameter.point);
  for (Command& command : commands_) agent_.points.remove(command.point);
}

void ProcessDebug::addStopwatches() {
  for (std::size_t i = 0; i < modules_.size(); ++i) {
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
                            ofModule_[parameter.module].configured, ofModule_[parameter.module].set);
    parameter.point.pass(value);
  }
}

void ProcessDebug::beginValues() {
  for (ValuePoint& value : values_) {
    if (!value.special || !value.point.active()) continue;
    RepresentationValue special(*value.loader, *value.special);
    value.point.pass(special);
  }
}

void ProcessDebug::addValue(const RepresentationLoader& loader, Representation& value) {
  values_.emplace_back(loader);
  values_.back().special = &value;
  agent_.points.add(values_.back().point);
}

void ProcessDebug::lookAround(const ThreadInfo& info) {
  beginValues();
  for (const Step& step : info.steps) updated(step);
}

std::map<std::string, ParameterValue> ProcessDebug::valuesOf(std::size_t module, Module& from) const {
  std::map<std::string, ParameterValue> values;
  plan_.modules[module].loader->description().parameters.visit(
      &from, [&](const std::string& path, const Parameter&, const ParameterPointer& pointer) {
        values.emplace(path, parameterValue(pointer));
      });
  return values;
}

void ProcessDebug::setAgain(std::size_t index, Module& next) {
  Parameters& parameters = ofModule_[index];
  parameters.next = valuesOf(index, next);
  if (parameters.set.empty()) return;
  plan_.modules[index].loader->description().parameters.visit(
      &next, [&](const std::string& path, const Parameter&, const ParameterPointer& pointer) {
        if (const auto set = parameters.set.find(path); set != parameters.set.end())
          setParameterValue(pointer, set->second);
      });
  next.parametersChanged();
}

void ProcessDebug::accepted(std::size_t index) { ofModule_[index].configured = ofModule_[index].next; }

void ProcessDebug::updated(const Step& step) {
  ValuePoint* of = ofStep_[step.index];
  if (!of || !of->point.active()) return;
  RepresentationValue value(*of->loader, *step.value);
  of->point.pass(value);
}

}  // namespace plumbline
