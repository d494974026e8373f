#include "framework/Process.h"

#include "framework/ConfigurationError.h"
#include "framework/CrashLog.h"
#include "framework/LogBuffer.h"
#include "framework/TracePlugin.h"

namespace plumbline {

Process::Process(const ThreadPlan& plan, ConfigStore& config, ModuleObjects& objects, StopSignal& stop)
    : plan_(plan), info_{plan.name, plan.priority, {}} {
  for (const CopyPlan& copy : plan.copies) {
    representations_[copy.representation->name()] = copy.representation->create();
  }
  for (const SpecialPlan& special : plan.specials) {
    specials_.push_back(SpecialModules::makers().at(special.name)(plan.name));
    for (const auto* loader : special.representations) {
      auto& holder = representations_[loader->name()] = loader->create();
      specials_.back()->provide(*loader, holder->get());
    }
  }
  for (const ModulePlan& module : plan.modules) {
    const ModuleDescription& description = module.loader->description();
    ModuleContext context{description.name, plan.name, config, objects, stop};
    ModuleContext::Scope scope(context);
    modules_.push_back(module.loader->create());
    const auto add = [&](const std::string& representation, const std::string& method, Representation* value,
                         void (*call)(Module&, Representation&)) {
      info_.steps.push_back({description.name, representation, description.name + ":" + method,
                             info_.steps.size(), modules_.back().get(), call, value});
    };
    add("", "execute", nullptr, nullptr);
    for (const ModuleOutput* output : module.outputs) {
      const std::string& name = output->representation->name();
      auto& holder = representations_[name] = output->representation->create();
      for (auto& special : specials_) special->offer(*output->representation, holder->get());
      add(name, "update" + name, &holder->get(), output->update);
    }
  }
  timing_ = std::make_unique<TimingPlugin>(info_);
}

Process::~Process() {
  // Later ones may hold on to what earlier ones made.
  while (!modules_.empty()) modules_.pop_back();
}

Representation* Process::find(const std::string& representation) const {
  const auto found = representations_.find(representation);
  return found == representations_.end() ? nullptr : &found->second->get();
}

void Process::init() {
  for (std::size_t i = 0; i < modules_.size(); i++) {
    for (const ModuleInput& input : plan_.modules[i].loader->description().inputs) {
      input.bind(*modules_[i], find(input.representation->name()));
    }
  }
  for (const auto& module : modules_) module->init();
}

void Process::start() {
  CrashRecord& record = LogBuffer::instance().record();
  crashThread_ = record.addThread(info_.name);
  CrashLog::protectThread();
  CrashRecord::enterThread(crashThread_);
  for (const Step& step : info_.steps) crashSteps_.push_back(record.addStep(step.label));
  plugins_ = Plugins::make();
  if (LogBuffer::instance().verbose()) plugins_.push_back(std::make_unique<TracePlugin>());
  for (auto& plugin : plugins_) plugin->threadStarted(info_);
  timing_->threadStarted(info_);
}

void Process::finish() {
  for (auto& plugin : plugins_) plugin->threadStopped();
  plugins_.clear();
}

void Process::cycle() {
  const auto begin = Plugin::Clock::now();
  CrashRecord& record = LogBuffer::instance().record();
  for (ThreadCopy* copy : fetched_) copy->fetch();
  for (auto& special : specials_) special->beginCycle();
  for (auto& plugin : plugins_) plugin->cycleStarted();
  try {
    // The end of a step is the beginning of the next unless plugins work in between: reading the clock is
    // the larger part of a step's overhead.
    auto now = begin;
    for (const Step& step : info_.steps) {
      current_ = &step;
      record.setStep(crashThread_, crashSteps_[step.index]);
      for (auto& plugin : plugins_)
        step.isExecute() ? plugin->beforeExecute(step) : plugin->beforeUpdate(step);
      if (!plugins_.empty() || step.index == 0) now = Plugin::Clock::now();
      step.isExecute() ? step.instance->execute() : step.call(*step.instance, *step.value);
      const Plugin::Duration duration{now, Plugin::Clock::now()};
      now = duration.end;
      timing_->afterExecute(step, duration);
      for (auto plugin = plugins_.rbegin(); plugin != plugins_.rend(); ++plugin) {
        step.isExecute() ? (*plugin)->afterExecute(step, duration) : (*plugin)->afterUpdate(step, duration);
      }
    }
  } catch (const ConfigurationError&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error("[" + info_.name + "] " + current_->label + ": " + error.what());
  }
  record.setStep(crashThread_, 0);
  for (ThreadCopy* copy : published_) copy->publish();
  for (auto& special : specials_) special->endCycle();
  const Plugin::Duration duration{begin, Plugin::Clock::now()};
  for (auto& plugin : plugins_) plugin->cycleFinished(duration);
  timing_->cycleFinished(duration);
}

}  // namespace plumbline
