#include "training/tasks/KickTask.h"

#include <algorithm>
#include <stdexcept>

#include "field/FieldSize.h"
#include "framework/ConfigurationError.h"
#include "math/Angle.h"
#include "math/GroundPose.h"
#include "motion/MotionDefaults.h"
#include "training/tasks/BeforeKick.h"
#include "training/tasks/WalkOn.h"
#include "trials/KickMeasure.h"

namespace plumbline::training {
namespace {

constexpr double dt = MotionTrial::dt;
constexpr int cyclesToFly = 10;  // after the motion, before the ball goes on alone
constexpr int mostStarts = 1000;
constexpr double leastScatter = 0.01, leastSpread = 0.05;  // that a file may have [rad, m]
constexpr double ballRadius = FieldSize().ballRadius;
constexpr std::size_t startsKept = 4096;

}  // namespace

KickTask::KickTask(const KickOptions& options)
    : options_(options), worlds_(options.world), ball_(worlds_.engine()) {
  try {
    const motion::KeyframeMotion& first = worlds_.first().motion(options.motion);
    kick_ = std::make_unique<motion::SearchedKick>(first, worlds_.first().model, options.foot());
  } catch (const std::logic_error& error) {  // out_of_range or invalid_argument
    throw ConfigurationError(std::string("option motion: ") + error.what());
  }
}

const KickTask::Start& KickTask::start(std::uint64_t seed) {
  if (const auto found = started_.find(seed); found != started_.end()) return found->second;
  if (started_.size() >= startsKept) started_.clear();
  MotionTrial& trial = worlds_.of(seed);
  for (int i = 0; i < mostStarts; ++i) {
    trial.seedStart(seed, i);
    trial.robot.restart(kickPlace, trial.stand);
    trial.restarted();
    if (!comesToKick(trial)) continue;
    Start start;
    const JointArray before = trial.robot.sense().angle;
    trial.step(trial.stand);
    start.torso = trial.robot.torso();
    start.angles = trial.robot.sense().angle;
    for (std::size_t j = 0; j < maxJoints; ++j) start.rates[j] = (start.angles[j] - before[j]) / dt;
    return started_[seed] = start;
  }
  throw std::runtime_error("the robot does not stand before the kick");
}

TaskOutcome KickTask::tryMotion(const motion::KeyframeMotion& kick, std::uint64_t seed) {
  const Start from = start(seed);
  MotionTrial& trial = worlds_.of(seed);
  simulation::LocalRobot& robot = trial.robot;
  robot.restart(from.torso.pose, from.angles);
  simulation::World& world = robot.world();
  world.setState(robot.robot(), from.torso, from.angles, from.rates);
  trial.restarted();
  trial.seedRun(seed);
  const double x = trial.random(-options_.spread, options_.spread),
               y = trial.random(-options_.spread, options_.spread);
  const Pose2 ground = groundPose(from.torso.pose);
  const Vec2 place = ground * Vec2(kick.ball + Vec2(x, y));
  world.setBall(Vec3(place.x(), place.y(), ballRadius), Vec3::Zero());
  WalkOn walk(trial, options_.walk, options_.still);

  int cycles = 0, contact = -1;
  KickMeasure measure(options_, ground, place);
  const auto watchBall = [&] {
    measure.see(world.ball().pose.translation());
    if (contact < 0 && !world.ballTouchedBy().empty()) contact = cycles;
  };
  trial.player.start(kick, robot.sense().angle);
  bool still = false;
  for (; !trial.player.finished(); ++cycles) {
    trial.player.step(dt, still);
    trial.step(trial.player.angles());
    watchBall();
    still = trial.still();
  }
  const double milliseconds = 1e3 * cycles * dt;
  walk.begin(trial.player.angles(), motion::walkFade);
  for (int i = 0; i < cyclesToFly; ++i, ++cycles) {
    walk.step();
    watchBall();
  }
  const simulation::BodyState flying = world.ball();
  while (!walk.isOver()) walk.step();

  const Vec2 rest = ball_.roll(flying, [&](const Vec3& ball) { measure.see(ball); });
  TaskOutcome outcome = measure.outcome({rest, milliseconds, walk.error(), walk.upright()});
  outcome.figures.emplace_back("contact", 1e3 * dt * (contact < 0 ? cycles : contact));
  return outcome;
}

TaskOutcome KickTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  return tryMotion(kick_->written(parameters, dt), seed);
}

std::string KickTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                           const std::map<std::string, double>& figures) const {
  motion::KeyframeMotion kick = kick_->written(parameters, dt);
  if (!figures.empty()) {
    const auto deviation = [&](const std::string& name) { return figures.at(name + deviationSuffix); };
    kick.kick = KickEffect{.distance = figures.at("distance"),
                           .direction = normalizeAngle(fromDegrees(figures.at("direction"))),
                           .contact = 1e-3 * figures.at("contact"),
                           .scatter = std::max(fromDegrees(deviation("direction")), leastScatter),
                           .spread = std::max(deviation("distance"), leastSpread),
                           .rise = std::max(figures.at("height"), 0.0)};
  }
  return motion::motionFile(kick, worlds_.first().model, heading);
}

MAKE_TASK(KickTask, "kick", "a kick")

}  // namespace plumbline::training
