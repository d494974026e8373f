#include "training/tasks/WalkTask.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/StopSignal.h"
#include "training/WalkingRobot.h"

namespace plumbline::training {
namespace {

constexpr double firstSigma = 0.5;  ///< of the first candidates, in first steps of the variables

WalkTrialKind directionOf(const std::string& name) {
  const auto found = std::ranges::find(walkTrialKindNames, name);
  if (found == walkTrialKindNames.end())
    throw ConfigurationError(
        fmt::format("option direction: \"{}\" is not one of {}", name, fmt::join(walkTrialKindNames, ", ")));
  return static_cast<WalkTrialKind>(found - walkTrialKindNames.begin());
}

/// "forward_step_height": without dots, which in a file would be maps within maps.
std::string nameOf(const WalkVariable& variable) {
  std::string name = (variable.section.empty() ? "" : variable.section + "_") + variable.parameter->path;
  std::ranges::replace(name, '.', '_');
  return name;
}

}  // namespace

WalkTask::WalkTask(const WalkOptions& options)
    : task_(directionOf(options.direction)), variables_(variablesOf(task_)) {
  const int type = checkedType(options.robot.type);
  trial_.tries = 1;
  trial_.seconds = options.seconds;
  trial_.push = options.push;
  trial_.alsoCut = true;
  first_ = readLeagueGaits(type);
  for (const WalkVariable& variable : variables_) {
    const double start = valueOf(first_, variable), step = variable.step;
    // A value on its bound may still move a little.
    parameters_.push_back(
        {nameOf(variable), start, std::min(start - 0.1 * step, variable.parameter->declared->range.min),
         std::max(start + 0.1 * step, variable.parameter->declared->range.max), firstSigma * step});
  }
  simulation::WorldConfig world;
  world.engine = options.robot.engine;
  if (!options.robot.effects.empty()) world.effects = simulation::readEffects(options.robot.effects);
  try {
    robot_ = std::make_unique<WalkingRobot>(type, first_, world);
  } catch (const std::invalid_argument& error) {  // an engine that there is not
    throw ConfigurationError(std::string("option engine: ") + error.what());
  }
  robot_->interrupt = StopSignal::throwIfCaught;
}

WalkTask::~WalkTask() = default;

walking::WalkGaits WalkTask::gaits(const Eigen::VectorXd& parameters) const {
  walking::WalkGaits result = first_;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const double value = parameters[static_cast<Eigen::Index>(i)];
    // What follows a value, as a step's shortest duration does, stays as the file has it where the value
    // does.
    if (value != parameters_[i].start) setValue(result, variables_[i], value);
  }
  return result;
}

TaskOutcome WalkTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  WalkTrialSetup trial = trial_;
  trial.seed = seed;
  const WalkTrialResult result = tryWalk(*robot_, gaits(parameters), task_, trial);
  TaskOutcome outcome;
  outcome.cost = walkCost(task_, result);
  outcome.figures = {
      {"speed", result.speed}, {"falls", result.falls}, {"drift", result.drift}, {"lean", result.lean}};
  return outcome;
}

std::string WalkTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                           const std::map<std::string, double>&) const {
  std::string line = heading;
  std::ranges::replace(line, '\n', ' ');  // walkFile's heading is one line
  return walkFile(gaits(parameters), plainWalk().base, line);
}

MAKE_TASK(WalkTask, "walk", "a walk at full speed")

}  // namespace plumbline::training
