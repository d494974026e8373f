#include "modules/optimization/OptimizationClient.h"

#include <unistd.h>

#include <new>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/SteadyClock.h"
#include "framework/WriteFile.h"
#include "modules/motion/Motions.h"
#include "modules/optimization/AgentTask.h"
#include "optimization/Optimizers.h"
#include "optimization/farm/FarmClient.h"
#include "robot/RobotTypes.h"

namespace plumbline {

MAKE_MODULE(OptimizationClient)

namespace {

constexpr double betweenTries = 0.5;  ///< to reach a server that is not there [s]

}  // namespace

/// A search in this process.
struct OptimizationClient::InAgent {
  std::unique_ptr<AgentTask> task;
  Search search;
};

OptimizationClient::OptimizationClient() = default;
OptimizationClient::~OptimizationClient() = default;

void OptimizationClient::want(const std::string& task, const TaskOptions& options) {
  wanted_.task = task;
  wanted_.options = options.lines();
}

void OptimizationClient::connect() {
  auto client = std::make_unique<farm::FarmClient>(farm::FarmAddress{host, port, token},
                                                   "agent-" + std::to_string(getpid()), stopDescriptor());
  if (client->isOver()) {
    source_ = std::move(client);
    return;
  }
  const farm::Welcome& welcome = client->welcome();
  const TaskOptions options(welcome.options);
  const auto task = AgentTask::make(welcome.task, options);
  const RobotTypes* types = findObject<RobotTypes>();
  if (!types)
    throw ConfigurationError("the server's " + welcome.task +
                             " is for a robot type; robots of this platform have no types");
  const std::string robot = types->nameOf(task->robotType());
  if (robot != theRobotDescription->name)
    throw ConfigurationError("the server's " + welcome.task + " is for " + robot + ", this robot is " +
                             theRobotDescription->name + ": give bin/agent --type");
  want(welcome.task, options);
  source_ = std::move(client);
}

void OptimizationClient::begin() {
  const TaskOptions taskOptions({{"motion", motion}});
  auto task = AgentTask::make("kick", taskOptions);
  try {
    task->begin(readMotions(config, theRobotDescription->model), theRobotDescription->model);
  } catch (const std::invalid_argument& error) {
    config.refuse("motion", error.what());
  }
  const SearchSpace space = SearchSpace::of(task->list());
  OptimizerOptions options;
  options.population = population;
  options.seed = static_cast<std::uint64_t>(seed);
  options.stop.maxGenerations = generations;
  inAgent_.reset(new InAgent{
      std::move(task), Search(makeOptimizer(optimizer, space, options), {runs, runs, true}, options.seed)});
  source_ = std::make_unique<farm::LocalSource>(inAgent_->search);
  want("kick", taskOptions);
}

void OptimizationClient::drop() {
  if (trial_) ++tries_;  // the next one is another try, even of the same numbers
  trial_.reset();
  source_.reset();
}

bool OptimizationClient::reach() {
  if (source_) return true;
  if (host.empty()) {
    begin();
    return true;
  }
  const double now = steadySeconds();
  if (now - asked_ < betweenTries) return false;
  asked_ = now;
  connect();
  lost_ = -1;
  return true;
}

void OptimizationClient::lose(const std::string& why) {
  drop();
  const double now = steadySeconds();
  if (lost_ < 0) {
    lost_ = now;
    log.warning() << why << "; waits for it";
  }
  if (host.empty() || now - lost_ >= patience) requestStop(2, why);
}

void OptimizationClient::takeResult() {
  if (!trial_ || !theOptimizationResult || theOptimizationResult->number != tries_) return;
  const OptimizationResult& result = *theOptimizationResult;
  ++tries_;
  costs_.push_back(result.cost);
  for (std::size_t i = 0; i < result.figures.size(); ++i)
    figures_[result.figures[i]] += result.values[i] / static_cast<double>(trial_->seeds.size());
  if (costs_.size() < trial_->seeds.size()) return;
  source_->tell(*trial_, costs_, figures_);
  trial_.reset();
}

void OptimizationClient::end() {
  if (ended_) return;
  ended_ = true;
  std::string what = "the search is over";
  if (inAgent_) {
    const Optimizer& optimiser = inAgent_->search.optimizer();
    const motion::KeyframeMotion best =
        inAgent_->task->written(optimiser.favourite(), theFrameInfo->cycleSeconds);
    const std::string text =
        motion::motionFile(best, theRobotDescription->model,
                           "Found in the agent: " + std::to_string(optimiser.generations()) +
                               " generations, seed " + std::to_string(seed) + ".");
    try {
      writeFile(found, text);
    } catch (const std::runtime_error& error) {  // nothing that comes later would end the agent
      return requestStop(2, error.what());
    }
    what += "; found: " + found;
    log << what;
  }
  requestStop(0, what);
}

void OptimizationClient::update(OptimizationTrial* theOptimizationTrial) {
  if (!theRobotDescription->known() || stopRequested()) return;
  theOptimizationTrial->open = false;
  try {
    if (!reach()) return;
    takeResult();
    if (source_->isOver()) end();
    // Nothing waits here: a trial that is not there yet may be in the next cycle.
    if (!trial_) {
      trial_ = source_->next(0);
      costs_.clear();
      figures_.clear();
    }
  } catch (const ConfigurationError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return ended_ ? drop() : lose(error.what());
  }
  *theOptimizationTrial = wanted_;
  theOptimizationTrial->open = trial_.has_value();
  if (!trial_) return;
  theOptimizationTrial->number = tries_;
  theOptimizationTrial->seed = trial_->seeds[costs_.size()];
  theOptimizationTrial->parameters.assign(trial_->parameters.begin(), trial_->parameters.end());
}

}  // namespace plumbline
