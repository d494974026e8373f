#include "training/tasks/WalkTask.h"

#include <algorithm>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/StopSignal.h"
#include "simspark/LeagueRobots.h"
#include "training/WalkingRobot.h"

namespace plumbline::training {
namespace {

constexpr double firstSigma = 0.5;  ///< of the first candidates, in first steps of the variables
const std::vector<std::string> directions{walking::taskNames.begin(), walking::taskNames.end()};

int walkType(const TaskOptions& options) {
  options.check({"type", "direction", "seconds", "push", "engine", "effects"});
  return static_cast<int>(options.number("type", 0, 0, numSimsparkTypes() - 1));
}

walking::Task directionOf(const TaskOptions& options) {
  const std::string word = options.word("direction", directions[0], directions);
  return static_cast<walking::Task>(std::ranges::find(directions, word) - directions.begin());
}

/// "forward_step_height": without dots, which in a file would be maps within maps.
std::string nameOf(const walking::Variable& variable) {
  std::string name = (variable.section.empty() ? "" : variable.section + "_") + variable.parameter->path;
  std::ranges::replace(name, '.', '_');
  return name;
}

}  // namespace

WalkTask::WalkTask(const TaskOptions& options)
    : task_(directionOf(options)), variables_(walking::variablesOf(task_)) {
  const int type = walkType(options);
  trial_.tries = 1;
  trial_.seconds = options.number("seconds", trial_.seconds, 2, 600);
  trial_.push = options.number("push", trial_.push, 0, 3);
  first_ = walking::readWalkGaits(type);
  for (const walking::Variable& variable : variables_) {
    const double start = walking::valueOf(first_, variable), step = variable.step;
    // A value on its bound may still move a little.
    parameters_.push_back(
        {nameOf(variable), start, std::min(start - 0.1 * step, variable.parameter->declared->range.min),
         std::max(start + 0.1 * step, variable.parameter->declared->range.max), firstSigma * step});
  }
  simulation::WorldConfig world;
  world.engine = options.word("engine", "ode");
  if (const std::string effects = options.word("effects", ""); !effects.empty())
    world.effects = simulation::readEffects(effects);
  try {
    robot_ = std::make_unique<walking::WalkingRobot>(type, first_, world);
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
    if (value != parameters_[i].start) walking::setValue(result, variables_[i], value);
  }
  return result;
}

TaskOutcome WalkTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  walking::TrialSetup trial = trial_;
  trial.seed = seed;
  const walking::TrialResult result = walking::tryWalk(*robot_, gaits(parameters), task_, trial);
  TaskOutcome outcome;
  outcome.cost = walking::cost(task_, result);
  outcome.figures = {{"speed", result.speed}, {"falls", result.falls}, {"drift", result.drift}};
  return outcome;
}

std::string WalkTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                           const std::map<std::string, double>&) const {
  std::string line = heading;
  std::ranges::replace(line, '\n', ' ');  // walkFile's heading is one line
  return walking::walkFile(gaits(parameters), walking::plainWalk().base, line);
}

MAKE_TASK(walk, {"walk", "a walk at full speed: type, direction, seconds, push, engine, effects (a file)",
                 [](const TaskOptions& options) -> std::unique_ptr<SearchTask> {
                   return std::make_unique<WalkTask>(options);
                 }});

}  // namespace plumbline::training
