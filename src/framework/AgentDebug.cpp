#include "framework/AgentDebug.h"

#include "framework/ModuleGraph.h"
#include "framework/TimingPlugin.h"
#include "framework/TimingReport.h"

namespace plumbline {

void AgentDebug::addStopwatch(const std::string& id, std::shared_ptr<const Stopwatch> stopwatch) {
  const std::lock_guard lock(mutex_);
  stopwatches_[id] = std::move(stopwatch);
}

bool AgentDebug::tryAddStopwatch(const std::string& id, std::shared_ptr<const Stopwatch> stopwatch) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock) stopwatches_[id] = std::move(stopwatch);
  return lock.owns_lock();
}

void AgentDebug::addThread(const ThreadPlan& plan, const TimingPlugin& timing) {
  const std::lock_guard lock(mutex_);
  threads_.push_back({&plan, &timing});
}

void AgentDebug::removeThread(const TimingPlugin& timing, const std::vector<std::string>& stopwatches) {
  const std::lock_guard lock(mutex_);
  std::erase_if(threads_, [&](const Thread& thread) { return thread.timing == &timing; });
  for (const std::string& id : stopwatches) stopwatches_.erase(id);
}

std::vector<AgentDebug::Provision> AgentDebug::provisions() const {
  const std::lock_guard lock(mutex_);
  std::vector<Provision> result;
  for (const Thread& thread : threads_) {
    const ThreadPlan& plan = *thread.plan;
    const auto add = [&](const RepresentationLoader& loader, const std::string& provider) {
      result.push_back({plan.name, loader.name(), provider});
    };
    for (const CopyPlan& copy : plan.copies) add(*copy.representation, copy.fromThread);
    for (const SpecialPlan& special : plan.specials)
      for (const auto* loader : special.representations) add(*loader, special.name);
    for (const ModulePlan& module : plan.modules)
      for (const ModuleOutput* output : module.outputs)
        add(*output->representation, module.loader->description().name);
  }
  return result;
}

std::map<std::string, std::shared_ptr<const Stopwatch>> AgentDebug::stopwatches() const {
  const std::lock_guard lock(mutex_);
  return stopwatches_;
}

std::string AgentDebug::timingReport() const {
  const std::lock_guard lock(mutex_);
  std::string text;
  for (const Thread& thread : threads_) text += plumbline::timingReport(*thread.timing, stopwatches_);
  return text;
}

void AgentDebug::addParameter(const std::string& id, ParameterInfo info) {
  const std::lock_guard lock(mutex_);
  parameters_[id] = std::move(info);
}

std::map<std::string, AgentDebug::ParameterInfo> AgentDebug::parameters() const {
  const std::lock_guard lock(mutex_);
  return parameters_;
}

std::vector<ThreadReport> AgentDebug::graph() const {
  const std::lock_guard lock(mutex_);
  std::vector<ThreadReport> reports;
  for (const Thread& thread : threads_) reports.push_back(reportThread(*thread.plan, *thread.timing));
  return reports;
}

}  // namespace plumbline
