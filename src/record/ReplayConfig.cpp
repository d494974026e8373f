#include "record/ReplayConfig.h"

#include <algorithm>
#include <set>

#include "framework/ConfigurationError.h"
#include "framework/ModuleGraph.h"
#include "framework/NearestName.h"

namespace plumbline::record {
namespace {

constexpr const char* logModule = "log";

bool has(const RecordedThread& thread, const std::string& representation) {
  return std::ranges::find(thread.topics, representation, &RecordedTopic::representation) !=
         thread.topics.end();
}

class Rewriter {
public:
  Rewriter(const ModulesConfig& modules, const LogReader& log, const std::vector<std::string>& compute,
           const std::string& platform)
      : plans_(planThreads(modules)), log_(log), compute_(compute), platform_(platform) {
    for (const ThreadPlan& plan : plans_)
      for (const ModulePlan& module : plan.modules) names_.push_back(module.loader->description().name);
    for (const std::string& name : compute_)
      if (std::ranges::find(names_, name) == names_.end())
        throw ConfigurationError("--compute " + name + ": " + modules.path + " has no such module" +
                                 suggestion(name, names_));
  }

  void rewrite(ThreadConfig& thread) {
    const ThreadPlan& plan = *std::ranges::find(plans_, thread.name, &ThreadPlan::name);
    const RecordedThread& recorded = recordedOf(thread.name);
    std::set<std::string> required;
    for (const ModulePlan& module : plan.modules) {
      if (!runs(module)) continue;
      for (const ModuleInput& input : module.inputs)
        if (input.kind == ModuleInput::Kind::required) required.insert(input.representation);
    }
    std::vector<ModulesConfigLine> lines;
    for (ModulesConfigLine& line : thread.lines) {
      const auto module = std::ranges::find(plan.modules, line.provider,
                                            [](const ModulePlan& m) { return m.loader->description().name; });
      const bool stays = module != plan.modules.end()
                             ? runs(*module)
                             : line.provider == logModule && line.representation.empty();
      if (!stays) {
        if (line.representation.empty()) continue;
        if (!has(recorded, line.representation)) {
          if (required.contains(line.representation))
            throw ConfigurationError(log_.path() + " has no " + line.representation +
                                     ", which a module that runs requires; let " + line.provider +
                                     " run as well");
          continue;
        }
        line.provider = logModule;
      }
      lines.push_back(line);
    }
    thread.lines = std::move(lines);
    for (const std::string& step : recorded.steps)
      if (step.ends_with(":execute")) thread.order.push_back(step.substr(0, step.size() - 8));
  }

private:
  const RecordedThread& recordedOf(const std::string& name) const {
    if (log_.threads().size() == 1) return log_.threads().front().recorded;
    return log_.thread(name).recorded;
  }

  bool runs(const ModulePlan& module) const {
    const ModuleDescription& description = module.loader->description();
    const bool elsewhere = description.area() != platform_;
    if (compute_.empty() || (module.outputs.empty() && elsewhere)) return elsewhere;
    return std::ranges::find(compute_, description.name) != compute_.end();
  }

  std::vector<ThreadPlan> plans_;
  const LogReader& log_;
  const std::vector<std::string>& compute_;
  const std::string& platform_;
  std::vector<std::string> names_;
};

}  // namespace

ModulesConfig replayConfig(ModulesConfig modules, const LogReader& log,
                           const std::vector<std::string>& compute, const std::string& platform) {
  Rewriter rewriter(modules, log, compute, platform);
  for (ThreadConfig& thread : modules.threads) rewriter.rewrite(thread);
  // A thread that only passed on the data of others has nothing to do.
  std::erase_if(modules.threads, [](const ThreadConfig& thread) { return thread.lines.empty(); });
  return modules;
}

}  // namespace plumbline::record
