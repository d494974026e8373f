#include "training/tasks/StandUpTask.h"

#include <cmath>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "motion/StandUpChoice.h"
#include "training/tasks/WalkOn.h"
#include "trials/StandUpMeasure.h"

namespace plumbline::training {
namespace {

constexpr std::size_t mostKept = 4096;
constexpr int mostFalls = 1000;
constexpr int mostRolls = 3;

/// As the agent: it rolls again where it still lies on a side.
void standUpAfterRoll(MotionTrial& trial, const motion::KeyframeMotion& roll) {
  trial.standUpChoice.forget();
  for (int i = 1; i < mostRolls && motion::lyingOn(trial.up()) == motion::LyingOn::side; ++i)
    trial.play(roll);
  if (!trial.upright()) trial.play(trial.nextStandUp());
}

}  // namespace

bool liesAs(const MotionTrial& trial, int direction) {
  const motion::LyingOn wanted = direction > 0   ? motion::LyingOn::front
                                 : direction < 0 ? motion::LyingOn::back
                                                 : motion::LyingOn::side;
  return motion::lyingOn(trial.up()) == wanted;
}

StandUpTask::StandUpTask(const StandUpOptions& options)
    : options_(options), direction_(options.side()), moving_(options.inPlay()), worlds_(options.world) {
  try {
    first_ = worlds_.first().motion(options.firstMotion());
  } catch (const std::out_of_range& error) {
    throw ConfigurationError(std::string("option motion: ") + error.what());
  }
  parameters_ = std::make_unique<motion::MotionParameters>(first_, worlds_.first().model);
}

bool StandUpTask::fits(const MotionTrial& trial) const {
  // A robot that came to lie on another side, or is on its feet, needs another motion. Limbs that overlap
  // would freeze when the motion begins.
  return liesAs(trial, direction_) && !trial.robot.overlaps() && !trial.robot.frozen().any();
}

bool StandUpTask::falls(MotionTrial& trial, std::uint64_t seed) const {
  // seed % count says which world, so the quotient says which fall: both happen in all worlds.
  if (moving_ && seed / worlds_.count() % 2 == 1) return trial.stumble(direction_);
  return trial.fall(direction_);
}

const StandUpTask::Lying& StandUpTask::lying(std::uint64_t seed) {
  if (const auto found = fallen_.find(seed); found != fallen_.end()) return found->second;
  if (fallen_.size() >= mostKept) fallen_.clear();
  MotionTrial& trial = worlds_.of(seed);
  for (int i = 0; i < mostFalls; ++i) {
    trial.seedStart(seed, i);
    if (!falls(trial, seed) || !fits(trial)) continue;
    Lying& lying = fallen_[seed] = trial.state();
    if (!moving_) lying.stop();
    return lying;
  }
  throw std::runtime_error("the robot does not fall");
}

TaskOutcome StandUpTask::tryMotion(const motion::KeyframeMotion& motion, std::uint64_t seed) {
  const Lying start = lying(seed);
  MotionTrial& trial = worlds_.of(seed);
  trial.begin(start);
  trial.seedRun(seed);
  trial.elapsed = 0;
  trial.play(motion);
  if (direction_ == 0) standUpAfterRoll(trial, motion);
  const double milliseconds = 1e3 * trial.elapsed;
  WalkOn walk(trial, StandUpOptions::walkSeconds, options_.still);
  walk.begin(trial.player.angles());
  while (!walk.isOver()) walk.step();
  return standUpOutcome(options_, milliseconds, walk.error(), walk.upright());
}

TaskOutcome StandUpTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  return tryMotion(parameters_->written(parameters, MotionTrial::dt), seed);
}

std::string StandUpTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                              const std::map<std::string, double>&) const {
  return motion::motionFile(parameters_->written(parameters, MotionTrial::dt), worlds_.first().model,
                            heading);
}

MAKE_TASK(StandUpTask, "standUp", "standing up from front, back or side")

}  // namespace plumbline::training
