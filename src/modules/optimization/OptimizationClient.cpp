#include "modules/optimization/OptimizationClient.h"

#include <unistd.h>

#include <charconv>
#include <limits>

#include "framework/ConfigurationError.h"
#include "framework/WriteFile.h"
#include "modules/motion/Motions.h"
#include "motion/SearchedKick.h"
#include "optimization/Optimizers.h"
#include "optimization/farm/FarmClient.h"
#include "robot/RobotTypes.h"

namespace plumbline {

MAKE_MODULE(OptimizationClient)

namespace {

/// A number among a task's options; throws ConfigurationError for what is none.
double number(const std::map<std::string, std::string>& options, const std::string& key, double fallback) {
  const auto found = options.find(key);
  if (found == options.end()) return fallback;
  double value = 0;
  const char* end = found->second.data() + found->second.size();
  if (std::from_chars(found->second.data(), end, value).ptr != end)
    throw ConfigurationError("the server's option " + key + ": \"" + found->second + "\" is no number");
  return value;
}

std::string word(const std::map<std::string, std::string>& options, const std::string& key,
                 const std::string& fallback) {
  const auto found = options.find(key);
  return found == options.end() ? fallback : found->second;
}

}  // namespace

/// A search in this process.
struct OptimizationClient::InAgent {
  motion::SearchedKick kick;
  Search search;
};

OptimizationClient::OptimizationClient() = default;
OptimizationClient::~OptimizationClient() = default;

void OptimizationClient::connect() {
  auto client = std::make_unique<farm::FarmClient>(farm::FarmAddress{host, port, token},
                                                   "agent-" + std::to_string(getpid()), stopDescriptor());
  const farm::Welcome& welcome = client->welcome();
  const auto& options = welcome.options;
  if (welcome.task != "kick")
    throw ConfigurationError("the server's task is " + welcome.task + "; an agent can try kicks (task kick)");
  for (const char* key : {"ceiling", "engine", "effects", "draws"})
    if (options.contains(key))
      throw ConfigurationError(std::string("the server's kick has the option ") + key +
                               "; an agent cannot try that, bin/optworker can");
  const RobotTypes* types = findObject<RobotTypes>();
  if (!types)
    throw ConfigurationError("the server's kick is for a robot type; robots of this platform have no types");
  const std::string robot = types->nameOf(static_cast<int>(number(options, "type", 0)));
  if (robot != theRobotDescription->name)
    throw ConfigurationError("the server's kick is for " + robot + ", this robot is " +
                             theRobotDescription->name + ": give bin/agent --type");
  const motion::KickWish wish;
  wanted_.motion = word(options, "motion", "kickRight");
  wanted_.foot = word(options, "side", "right") == "left" ? Side::left : Side::right;
  wanted_.spread = number(options, "spread", wanted_.spread);
  wanted_.distance = number(options, "distance", wish.distance);
  wanted_.weight = number(options, "weight", wish.weight);
  wanted_.steady = number(options, "steady", wish.steady);
  source_ = std::move(client);
}

void OptimizationClient::begin() {
  const auto motions = readMotions(config, theRobotDescription->model);
  const motion::KeyframeMotion* first = findMotion(motions, motion);
  if (!first) config.refuse("motion", motion::missingMotion(motions, motion));
  motion::SearchedKick kick(*first, theRobotDescription->model, Side::right);
  const SearchSpace space = SearchSpace::of(kick.list());
  OptimizerOptions options;
  options.population = population;
  options.seed = static_cast<std::uint64_t>(seed);
  options.stop.maxGenerations = generations;
  inAgent_.reset(new InAgent{
      std::move(kick), Search(makeOptimizer(optimizer, space, options), {runs, runs, true}, options.seed)});
  source_ = std::make_unique<farm::LocalSource>(inAgent_->search);
  const motion::KickWish wish;
  wanted_.motion = motion;
  wanted_.weight = wish.weight;
  wanted_.steady = wish.steady;
}

void OptimizationClient::takeResult() {
  if (!trial_ || !theOptimizationResult || theOptimizationResult->number != tries_) return;
  const OptimizationResult& result = *theOptimizationResult;
  ++tries_;
  costs_.push_back(result.cost);
  const double share = 1 / static_cast<double>(trial_->seeds.size());
  for (const auto& [name, value] : {std::pair<const char*, double>{"distance", result.distance},
                                    {"direction", result.direction},
                                    {"time", result.time},
                                    {"error", result.error},
                                    {"up", result.up ? 1.0 : 0.0}})
    figures_[name] += share * value;
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
    const motion::KeyframeMotion kick =
        inAgent_->kick.written(optimiser.favourite(), theFrameInfo->cycleSeconds);
    writeFile(found, motion::motionFile(kick, theRobotDescription->model,
                                        "Found in the agent: " + std::to_string(optimiser.generations()) +
                                            " generations, seed " + std::to_string(seed) + "."));
    what += "; found: " + found;
    log << what;
  }
  requestStop(0, what);
}

void OptimizationClient::update(OptimizationTrial* theOptimizationTrial) {
  if (!theRobotDescription->known() || stopRequested()) return;
  try {
    if (!source_) host.empty() ? begin() : connect();
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
  } catch (const std::exception& error) {
    if (!ended_) requestStop(2, error.what());
    return;
  }
  *theOptimizationTrial = wanted_;
  theOptimizationTrial->open = trial_.has_value();
  if (!trial_) return;
  theOptimizationTrial->number = tries_;
  theOptimizationTrial->seed = trial_->seeds[costs_.size()];
  theOptimizationTrial->parameters.assign(trial_->parameters.begin(), trial_->parameters.end());
}

}  // namespace plumbline
