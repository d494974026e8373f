#include "framework/GraphReport.h"

#include <algorithm>

#include "framework/ModuleGraph.h"
#include "framework/TimingPlugin.h"

namespace plumbline {
namespace {

void addTimes(const TimingPlugin& timing, ModuleReport& module) {
  double time = 0, waited = 0;
  for (const TimingPlugin::Entry& entry : timing.steps()) {
    if (entry.module != module.name) continue;
    time += 1e6 * entry.stopwatch->mean();
    module.overruns += entry.overruns.load(std::memory_order_relaxed);
    waited += 1e-3 * static_cast<double>(entry.waited.load(std::memory_order_relaxed));
  }
  const double cycles = std::max(1.0, static_cast<double>(timing.cycle().count()));
  module.wait = waited / cycles;
  module.time = std::max(0.0, time - module.wait);
}

}  // namespace

ThreadReport reportThread(const ThreadPlan& plan, const TimingPlugin& timing) {
  ThreadReport report;
  report.name = plan.name;
  report.load = timing.load();
  report.rate = timing.rate();
  report.time = 1e6 * timing.busy().mean();
  report.cycles = timing.cycle().count();
  report.overruns = timing.overruns();
  for (const CopyPlan& copy : plan.copies)
    report.copies.push_back({copy.fromThread, copy.representation->name()});
  for (const SpecialPlan& special : plan.specials) {
    ModuleReport& module = report.modules.emplace_back();
    module.name = special.name;
    for (const auto* loader : special.representations) module.provides.push_back(loader->name());
  }
  for (const ModulePlan& planned : plan.modules) {
    ModuleReport& module = report.modules.emplace_back();
    const ModuleDescription& description = planned.loader->description();
    module.name = description.name;
    module.area = description.area();
    addTimes(timing, module);
    for (const ModuleOutput* output : planned.outputs)
      module.provides.push_back(output->representation->name());
    for (const ModuleInput& input : planned.inputs) {
      const std::string& name = input.representation;
      if (plan.provider(name).empty()) continue;
      (input.kind == ModuleInput::Kind::used ? module.uses : module.reads).push_back(name);
    }
  }
  return report;
}

}  // namespace plumbline
