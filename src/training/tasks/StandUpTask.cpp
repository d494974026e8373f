#include "training/tasks/StandUpTask.h"

#include <cmath>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "training/tasks/WalkOn.h"

namespace plumbline::training {
namespace {

constexpr std::size_t mostKept = 4096;
constexpr int mostFalls = 1000;
constexpr double walkSeconds = 2;

}  // namespace

StandUpTask::StandUpTask(const TaskOptions& options)
    : direction_(options.word("direction", "front", {"front", "back"}) == "front" ? 1 : -1),
      weight_(options.number("weight", 0.08, 0, 100)),
      still_(options.number("still", 0, 0, 1)),
      worlds_(options, robotTypeOf(options, {"direction", "weight", "motion", "still"})) {
  try {
    first_ = worlds_.first().motion(options.word("motion", direction_ > 0 ? "standUpFront" : "standUpBack"));
  } catch (const std::out_of_range& error) {
    throw ConfigurationError(std::string("option motion: ") + error.what());
  }
  parameters_ = std::make_unique<motion::MotionParameters>(first_, worlds_.first().model);
}

const StandUpTask::Lying& StandUpTask::lying(std::uint64_t seed) {
  if (const auto found = fallen_.find(seed); found != fallen_.end()) return found->second;
  if (fallen_.size() >= mostKept) fallen_.clear();
  motion::MotionTrial& trial = worlds_.of(seed);
  for (int i = 0; i < mostFalls; ++i) {
    // A fall that ends on a side, or on the feet, is another motion's.
    trial.seedStart(seed, i);
    if (!trial.fall(direction_)) continue;
    const Vec3 up = trial.up();
    if (std::abs(up.x()) < std::abs(up.y()) || (up.x() < 0) != (direction_ > 0)) continue;
    // Its joints were put anywhere: limbs that overlap from there would freeze when the motion begins.
    if (trial.robot.overlaps() || trial.robot.frozen().any()) continue;
    return fallen_[seed] = {trial.robot.torso().pose, trial.robot.sense().angle};
  }
  throw std::runtime_error("the robot does not fall");
}

TaskOutcome StandUpTask::tryMotion(const motion::KeyframeMotion& motion, std::uint64_t seed) {
  const Lying start = lying(seed);
  motion::MotionTrial& trial = worlds_.of(seed);
  trial.robot.restart(start.T_world_torso, start.angles);
  trial.restarted();
  trial.seedRun(seed);
  trial.elapsed = 0;
  trial.play(motion);
  TaskOutcome outcome;
  const double milliseconds = 1e3 * trial.elapsed;
  WalkOn walk(trial, walkSeconds, still_);
  walk.begin(trial.player.angles());
  while (!walk.isOver()) walk.step();
  outcome.cost = walk.error() + weight_ * milliseconds;
  outcome.figures = {{"time", milliseconds}, {"error", walk.error()}, {"up", walk.upright() ? 1.0 : 0.0}};
  return outcome;
}

TaskOutcome StandUpTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  return tryMotion(parameters_->written(parameters, motion::MotionTrial::dt), seed);
}

std::string StandUpTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                              const std::map<std::string, double>&) const {
  return motion::motionFile(parameters_->written(parameters, motion::MotionTrial::dt), worlds_.first().model,
                            heading);
}

MAKE_TASK(standUp, {"standUp",
                    "standing up from front or back: type, direction, weight, motion, still, engine, effects "
                    "(a file), draws, firstDraw",
                    [](const TaskOptions& options) -> std::unique_ptr<SearchTask> {
                      return std::make_unique<StandUpTask>(options);
                    }});

}  // namespace plumbline::training
