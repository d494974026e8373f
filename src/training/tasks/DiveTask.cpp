#include "training/tasks/DiveTask.h"

#include <cmath>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "tactics/RollingBall.h"

namespace plumbline::training {
namespace {

constexpr double cycle = motion::MotionTrial::dt;
constexpr double slowest = 2.5, fastest = 7;  // of a shot when it crosses the keeper's line [m/s]
constexpr double widest = 0.3;                // angle between a shot and the keeper's own direction [rad]
constexpr double past = 0.35;                 // behind the keeper's line a ball is past it [m]
constexpr double after = 0.8;                 // so long a ball may touch the keeper and still get past [s]
constexpr double lean = 0.035;                // of the torso at the begin, at most [rad]
const double radius = simulation::WorldConfig().field.ballRadius;

int robotType(const TaskOptions& options) {
  options.check(withWorldOptions({"type", "motion", "least", "most", "soonest", "latest", "weight"}));
  return static_cast<int>(options.number("type", 0, 0, numSimsparkTypes() - 1));
}

}  // namespace

DiveTask::DiveTask(const TaskOptions& options)
    : least_(options.number("least", 0.1, 0, 2)),
      most_(options.number("most", 0.9, 0, 2)),
      soonest_(options.number("soonest", 0.3, 0.02, 5)),
      latest_(options.number("latest", 0.8, 0.02, 5)),
      weight_(options.number("weight", 0.02, 0, 100)),
      worlds_(options, robotType(options)) {
  try {
    first_ = worlds_.first().motion(options.word("motion", "diveRight"));
  } catch (const std::out_of_range& error) {
    throw ConfigurationError(std::string("option motion: ") + error.what());
  }
  parameters_ =
      std::make_unique<motion::MotionParameters>(first_, worlds_.first().model, motion::Sides::apart);
}

Shot DiveTask::shotOf(std::uint64_t seed) {
  motion::MotionTrial& trial = worlds_.of(seed);
  trial.seed(static_cast<unsigned>(seed * 2654435761U + 1));
  Shot shot;
  shot.aside = trial.random(least_, most_);
  shot.seconds = trial.random(soonest_, latest_);
  const double speed = trial.random(slowest, fastest), angle = trial.random(-widest, widest);
  const Vec2 back(std::cos(angle), std::sin(angle));
  // A rolling ball's speed dies away exponentially: going back in time it grows.
  const double before = speed * std::exp(shot.seconds / ballRollingSeconds);
  shot.from = Vec2(0, -shot.aside) + ballRollingSeconds * (before - speed) * back;
  shot.velocity = -before * back;
  return shot;
}

TaskOutcome DiveTask::tryMotion(const motion::KeyframeMotion* dive, std::uint64_t seed) {
  const Shot shot = shotOf(seed);
  motion::MotionTrial& trial = worlds_.of(seed);
  simulation::LocalRobot& robot = trial.robot;
  robot.restart(Pose2(), trial.stand);
  trial.restarted();
  JointArray leaning = trial.stand;
  const double roll = trial.random(-lean, lean);
  for (const JointId joint : {lHipRoll, rHipRoll}) leaning[joint] += roll;
  for (const JointId joint : {lAnkleRoll, rAnkleRoll}) leaning[joint] -= roll;
  for (int i = 0; i < 5; ++i) trial.step(leaning);
  for (int i = 0; i < 5; ++i) trial.step(trial.stand);
  simulation::World& world = robot.world();
  world.setBall(Vec3(shot.from.x(), shot.from.y(), radius), Vec3(shot.velocity.x(), shot.velocity.y(), 0));
  if (dive) trial.player.start(*dive, robot.sense().angle);
  bool gone = false;
  double seconds = 0;
  for (double t = 0; t < shot.seconds + after && !gone; t += cycle) {
    if (dive && !trial.player.finished()) {
      trial.player.step(cycle, trial.still());
      seconds += cycle;
    }
    trial.step(dive ? trial.player.angles() : trial.stand);
    gone = world.ball().pose.translation().x() < -past;
  }
  for (; dive && !trial.player.finished(); seconds += cycle) {
    trial.player.step(cycle, trial.still());
    trial.step(trial.player.angles());
  }
  TaskOutcome outcome;
  outcome.cost = (gone ? 1 : 0) + weight_ * seconds;
  outcome.figures = {{"blocked", gone ? 0.0 : 1.0}, {"aside", shot.aside}, {"time", 1e3 * seconds}};
  return outcome;
}

TaskOutcome DiveTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  const motion::KeyframeMotion dive = parameters_->written(parameters, cycle);
  return tryMotion(&dive, seed);
}

std::string DiveTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                           const std::map<std::string, double>&) const {
  return motion::motionFile(parameters_->written(parameters, cycle), worlds_.first().model, heading);
}

MAKE_TASK(dive, {"dive",
                 "a keeper's dive to its right: type, motion, least, most, soonest, latest, weight, engine, "
                 "effects (a file), draws, firstDraw",
                 [](const TaskOptions& options) -> std::unique_ptr<SearchTask> {
                   return std::make_unique<DiveTask>(options);
                 }});

}  // namespace plumbline::training
