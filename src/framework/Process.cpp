#include "framework/Process.h"

#include <algorithm>
#include <set>

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"
#include "framework/CrashLog.h"
#include "framework/LogBuffer.h"
#include "framework/ModuleParameters.h"
#include "framework/SingleLine.h"
#include "framework/TracePlugin.h"

namespace plumbline {
namespace {

/// Runs part of a module; what it throws says where it was thrown.
template <typename F>
void named(const std::string& label, F&& function) {
  try {
    function();
  } catch (const ConfigurationError&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error(label + ": " + errorLine(error));
  }
}

}  // namespace

Process::Process(const ThreadPlan& plan, ConfigStore& config, ModuleObjects& objects, StopSignal& stop,
                 std::shared_ptr<AgentDebug> debug)
    : plan_(plan),
      info_{plan.name, plan.priority, {}, plan.rate},
      config_(config),
      objects_(objects),
      stop_(stop),
      agentDebug_(std::move(debug)) {
  for (const CopyPlan& copy : plan.copies) {
    representations_[copy.representation->name()] = copy.representation->create();
  }
  makeSpecials();
  for (const ModulePlan& module : plan.modules) {
    const ModuleDescription& description = module.loader->description();
    modules_.push_back(makeModule(modules_.size()));
    const auto add = [&](const std::string& representation, const std::string& method, Representation* value,
                         void (*call)(Module&, Representation&)) {
      info_.steps.push_back({description.name, representation, description.name + ":" + method,
                             info_.steps.size(), modules_.back().get(), call, value});
      guards_.emplace_back();
    };
    add("", "execute", nullptr, nullptr);
    for (const ModuleOutput* output : module.outputs) {
      const std::string& name = output->representation->name();
      auto& holder = representations_[name] = output->representation->create();
      add(name, "update" + name, &holder->get(), output->update);
      guards_.back().emplace(*output->representation, holder->get());
    }
  }
  offerToSpecials();
  timing_ = std::make_unique<TimingPlugin>(info_);
  debug_ = std::make_unique<ProcessDebug>(*agentDebug_, plan_, info_, modules_, *timing_);
  for (const SpecialPlan& special : plan_.specials)
    for (const auto* loader : special.representations) debug_->addValue(*loader, *find(loader->name()));
}

void Process::makeSpecials() {
  for (const SpecialPlan& special : plan_.specials) {
    ModuleContext context{special.name, info_.name, config_, objects_, stop_};
    const ModuleContext::Scope scope(context);
    specials_.push_back(SpecialModules::makers().at(special.name)(plan_.name));
    for (const auto* loader : special.representations) {
      auto& holder = representations_[loader->name()] = loader->create();
      specials_.back()->provide(*loader, holder->get());
    }
  }
}

void Process::offerToSpecials() {
  for (std::size_t i = 0; i < specials_.size(); ++i) {
    const auto offer = [&](const RepresentationLoader& loader) {
      specials_[i]->offer(loader, *find(loader.name()));
    };
    for (const CopyPlan& copy : plan_.copies) offer(*copy.representation);
    for (const SpecialPlan& special : plan_.specials) {
      if (&special == &plan_.specials[i]) continue;
      for (const auto* loader : special.representations) offer(*loader);
    }
    for (const ModulePlan& module : plan_.modules) {
      for (const ModuleOutput* output : module.outputs) offer(*output->representation);
    }
    specials_[i]->planned(plan_);
  }
}

Process::~Process() {
  debug_.reset();
  // Later ones may hold on to what earlier ones made.
  while (!modules_.empty()) modules_.pop_back();
}

Representation* Process::find(const std::string& representation) const {
  const auto found = representations_.find(representation);
  return found == representations_.end() ? nullptr : &found->second->get();
}

std::unique_ptr<Module> Process::makeModule(std::size_t index) {
  const ModuleLoader& loader = *plan_.modules[index].loader;
  const std::string& name = loader.description().name;
  ModuleContext context{name, info_.name, config_, objects_, stop_};
  ModuleContext::Scope scope(context);
  CrashPlace place(LogBuffer::instance().record(), info_.name);
  place.enter(name + ":create");
  std::unique_ptr<Module> module;
  named("[" + info_.name + "] " + name + ":create", [&] { module = loader.create(); });
  configureModule(*module, loader.description(), config_);
  if (debug_) debug_->setAgain(index, *module);
  return module;
}

void Process::connectModule(Module& module, std::size_t index) {
  for (const ModuleInput& input : plan_.modules[index].inputs) {
    input.bind(module, find(input.representation));
  }
}

void Process::initModule(Module& module, std::size_t index) {
  CrashPlace place(LogBuffer::instance().record(), info_.name);
  const std::string label = plan_.modules[index].loader->description().name + ":init";
  place.enter(label);
  named("[" + info_.name + "] " + label, [&] { module.init(); });
}

void Process::init() {
  for (std::size_t i = 0; i < modules_.size(); ++i) connectModule(*modules_[i], i);
  for (std::size_t i = 0; i < modules_.size(); ++i) initModule(*modules_[i], i);
  std::set<std::string> files;
  for (const ModulePlan& module : plan_.modules) {
    const ModuleDescription& description = module.loader->description();
    if (!description.parameters.empty()) files.insert(description.name);
    files.merge(config_.filesOf(description.name));
  }
  debug_->addCommands({files.begin(), files.end()});
  configVersion_ = config_.version();
}

void Process::replaceModule(std::size_t index, std::unique_ptr<Module> next) {
  const Module* old = modules_[index].get();
  for (Step& step : info_.steps) {
    if (step.instance == old) step.instance = next.get();
  }
  std::erase(rejected_, old);
  modules_[index] = std::move(next);
  debug_->accepted(index);
}

void Process::resetModule(std::size_t index) {
  std::unique_ptr<Module> next = makeModule(index);
  connectModule(*next, index);
  initModule(*next, index);
  replaceModule(index, std::move(next));
}

void Process::reject(const Step& step, const std::string& problem) {
  log_.error() << "[" << info_.name << "] " << step.label << ": " << problem
               << "; the last good value is kept and the module restarts";
  if (std::find(rejected_.begin(), rejected_.end(), step.instance) == rejected_.end())
    rejected_.push_back(step.instance);
}

void Process::remakeModules() {
  // Only behind the last step: what else a module provides in a cycle rests on its own execute.
  for (std::size_t i = 0; i < modules_.size(); ++i) {
    const Module* old = modules_[i].get();
    if (std::find(rejected_.begin(), rejected_.end(), old) != rejected_.end()) resetModule(i);
  }
}

void Process::restart() {
  // What provides nothing takes no part in what is computed: a debug port stays open.
  for (const ModulePlan& module : plan_.modules) {
    for (const ModuleOutput* output : module.outputs) {
      Representation& value = *find(output->representation->name());
      const auto fresh = output->representation->create();
      output->representation->copy(fresh->get(), value);
      for (const Step& step : info_.steps) {
        if (step.value == &value) guards_[step.index].emplace(*output->representation, value);
      }
    }
  }
  for (std::size_t i = 0; i < modules_.size(); ++i) {
    if (!plan_.modules[i].outputs.empty()) resetModule(i);
  }
}

bool Process::takesTurn() {
  unseen_ = false;
  for (auto& special : specials_) {
    const SpecialModule::Turn turn = special->turn();
    unseen_ = unseen_ || turn == SpecialModule::Turn::unseen;
    if (turn == SpecialModule::Turn::cycle || turn == SpecialModule::Turn::unseen) continue;
    if (turn == SpecialModule::Turn::restart) {
      restart();
    } else if (debug_->wanted()) {
      debug_->beginCycle();
      debug_->lookAround(info_);
      runCommands();
    }
    return false;
  }
  return true;
}

void Process::start() {
  if (running_) return;
  running_ = true;
  record_ = &LogBuffer::instance().record();
  crashThread_ = record_->addThread(info_.name);
  CrashLog::protectThread();
  CrashRecord::enterThread(crashThread_);
  for (const Step& step : info_.steps) crashSteps_.push_back(record_->addStep(step.label));
  plugins_ = Plugins::make();
  if (LogBuffer::instance().verbose()) plugins_.push_back(std::make_unique<TracePlugin>());
  for (auto& plugin : plugins_) plugin->threadStarted(info_);
  timing_->threadStarted(info_);
}

void Process::finish() {
  if (!running_) return;
  running_ = false;
  for (auto& plugin : plugins_) plugin->threadStopped();
  plugins_.clear();
  timing_->threadStopped();
  record_->removeThread(crashThread_);
  CrashRecord::enterThread(-1);
}

void Process::runSteps(Plugin::Clock::time_point now) {
  std::size_t module = 0;
  for (const Step& step : info_.steps) {
    current_ = &step;
    record_->setStep(crashThread_, crashSteps_[step.index]);
    for (auto& plugin : plugins_) step.isExecute() ? plugin->beforeExecute(step) : plugin->beforeUpdate(step);
    // The end of a step is the beginning of the next unless plugins work in between: reading the clock is the
    // larger part of a step's overhead.
    if (!plugins_.empty() || step.index == 0) now = Plugin::Clock::now();
    if (step.isExecute()) {
      for (auto& special : specials_) special->beforeModule(module);
      module++;
      step.instance->execute();
    } else {
      step.call(*step.instance, *step.value);
      if (const std::string problem = guards_[step.index]->check(); !problem.empty()) reject(step, problem);
      if (debugging_) debug_->updated(step);
    }
    const Plugin::Duration duration{now, Plugin::Clock::now()};
    now = duration.end;
    timing_->afterExecute(step, duration);
    for (auto plugin = plugins_.rbegin(); plugin != plugins_.rend(); ++plugin) {
      step.isExecute() ? (*plugin)->afterExecute(step, duration) : (*plugin)->afterUpdate(step, duration);
    }
  }
}

void Process::cycle() {
  if (!takesTurn()) return;
  const auto begin = Plugin::Clock::now();
  for (ThreadCopy* copy : fetched_) copy->fetch();
  for (auto& special : specials_) special->beginCycle();
  for (auto& plugin : plugins_) plugin->cycleStarted();
  debugging_ = !unseen_ && debug_->wanted();
  if (debugging_) {
    debug_->beginCycle();
    debug_->beginValues();
  }
  try {
    runSteps(begin);
  } catch (const ConfigurationError&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error("[" + info_.name + "] " + current_->label + ": " + errorLine(error));
  }
  if (!rejected_.empty()) remakeModules();
  if (config_.version() != configVersion_) followReloads();
  if (debugging_) runCommands();
  record_->setStep(crashThread_, 0);
  for (ThreadCopy* copy : published_) copy->publish();
  for (auto& special : specials_) special->endCycle();
  const Plugin::Duration duration{begin, Plugin::Clock::now()};
  for (auto& plugin : plugins_) plugin->cycleFinished(duration);
  timing_->cycleFinished(duration);
}

}  // namespace plumbline
