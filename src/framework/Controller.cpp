#include "framework/Controller.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

#include "framework/AgentDebug.h"
#include "framework/ConfigurationError.h"
#include "framework/Log.h"
#include "framework/Process.h"
#include "framework/SingleLine.h"
#include "framework/ThreadCopy.h"
#include "framework/ThreadPriority.h"
#include "framework/TimingReport.h"

namespace plumbline {

Controller::Controller(ControllerOptions options)
    : Controller(options, readModulesConfig(options.modulesConfig)) {}

Controller::Controller(ControllerOptions options, std::string_view modulesConfigText)
    : Controller(options, parseModulesConfig(modulesConfigText, options.modulesConfig)) {}

Controller::Controller(ControllerOptions options, const ModulesConfig& modules)
    : options_(std::move(options)),
      debug_(std::make_shared<AgentDebug>()),
      config_(options_.configDirectories),
      plans_(planThreads(modules)) {}

Controller::~Controller() {
  for (auto& process : processes_) process->finish();
  while (!processes_.empty()) processes_.pop_back();
}

Process* Controller::process(const std::string& thread) const {
  for (const auto& process : processes_) {
    if (thread.empty() || process->name() == thread) return process.get();
  }
  return nullptr;
}

void Controller::init() {
  if (initialized_) return;
  initialized_ = true;
  objects_.set(debug_);
  for (const ThreadPlan& plan : plans_) {
    processes_.push_back(std::make_unique<Process>(plan, config_, objects_, stop_, debug_));
  }
  std::map<std::pair<std::string, std::string>, ThreadCopy*> copyOf;  // by source and destination
  for (const ThreadPlan& plan : plans_) {
    for (const CopyPlan& copy : plan.copies) {
      Process& source = *process(copy.fromThread);
      Process& destination = *process(plan.name);
      ThreadCopy*& way = copyOf[{source.name(), destination.name()}];
      if (!way) {
        copies_.push_back(std::make_unique<ThreadCopy>());
        way = copies_.back().get();
        source.addPublished(*way);
        destination.addFetched(*way);
      }
      const std::string& name = copy.representation->name();
      way->add(*copy.representation, *source.find(name), *destination.find(name));
    }
  }
  for (const auto& process : processes_) process->init();
  // A module may have a config file and read nothing: its keys are unknown as well.
  for (const ThreadPlan& plan : plans_) {
    for (const ModulePlan& module : plan.modules) {
      const std::string& name = module.loader->description().name;
      if (config_.exists(name)) config_.file(name);
    }
  }
  config_.checkUnknown();
}

void Controller::runProcess(Process& process) {
  try {
    process.start();
    while (!stop_.requested()) process.cycle();
  } catch (const ConfigurationError& error) {
    stop_.request(ConfigurationError::exitCode, error.what());
    std::lock_guard lock(errorMutex_);
    if (!configurationError_) configurationError_ = std::current_exception();
  } catch (const std::exception& error) {
    stop_.request(1, errorLine(error));
  }
  process.finish();
}

int Controller::run() {
  init();
  int highest = 0;
  for (const auto& process : processes_) {
    if (process->priority() < ThreadConfig::maxPriority) highest = std::max(highest, process->priority());
  }
  const auto runThread = [&](Process& process) {
    const std::string refused = applyThreadPriority(process.priority(), highest);
    if (!refused.empty()) {
      Log("framework").warning() << "priority " << process.priority() << " of thread " << process.name()
                                 << ": " << refused;
    }
    runProcess(process);
  };
  if (processes_.size() == 1) {
    runThread(*processes_.front());
  } else {
    std::vector<std::thread> threads;
    for (const auto& process : processes_) threads.emplace_back(runThread, std::ref(*process));
    for (std::thread& thread : threads) thread.join();
  }
  if (configurationError_) std::rethrow_exception(configurationError_);
  return stop_.exitCode();
}

std::size_t Controller::runCycles(std::size_t count) {
  init();
  if (processes_.size() != 1) throw std::logic_error("runCycles runs agents of a single thread");
  processes_.front()->start();
  std::size_t done = 0;
  for (; done < count && !stop_.requested(); ++done) processes_.front()->cycle();
  processes_.front()->updateTiming();
  return done;
}

const Representation* Controller::findRepresentation(const std::string& name,
                                                     const std::string& thread) const {
  const Process* found = process(thread);
  return found ? found->find(name) : nullptr;
}

const TimingPlugin* Controller::timing(const std::string& thread) const {
  const Process* found = process(thread);
  return found ? &found->timing() : nullptr;
}

std::string Controller::timingReport() const {
  for (const auto& process : processes_) process->addStopwatches();
  return debug_->timingReport();
}

std::map<std::string, double> Controller::moduleTimes() const {
  std::map<std::string, double> times;
  for (const auto& process : processes_) times.merge(plumbline::moduleTimes(*process));
  return times;
}

}  // namespace plumbline
