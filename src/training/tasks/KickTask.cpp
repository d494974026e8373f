#include "training/tasks/KickTask.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "math/Angle.h"
#include "math/GroundPose.h"
#include "motion/MotionDefaults.h"
#include "training/tasks/BeforeKick.h"
#include "training/tasks/WalkOn.h"

namespace plumbline::training {
namespace {

constexpr double dt = MotionTrial::dt;
constexpr int cyclesToFly = 10;  // after the motion, before the ball goes on alone
constexpr int mostStarts = 1000;
constexpr double leastScatter = 0.01, leastSpread = 0.05;  // that a file may have [rad, m]
const FieldSize field = simulation::WorldConfig().field;   // of the trial's world
const double ballRadius = field.ballRadius;
constexpr double shotFrom = 3, shotTo = 8;  // where a goal stands that one shoots at [m]
constexpr std::size_t startsKept = 4096;

/// The highest that the ball's top comes where a goal may stand.
struct Flight {
  Vec2 from;
  double top = 0;
  bool came = false;  ///< so far

  void see(const Vec3& ball) {
    const double way = (ball.head<2>() - from).norm();
    if (way < shotFrom || way > shotTo) return;
    came = true;
    top = std::max(top, ball.z() + ballRadius);
  }
};

}  // namespace

KickTask::KickTask(const KickOptions& options)
    : options_(options),
      direction_(fromDegrees(options.direction)),
      worlds_(options.world),
      ball_(worlds_.engine()) {
  const Side foot = options.side == "left" ? Side::left : Side::right;
  try {
    const motion::KeyframeMotion& first = worlds_.first().motion(options.motion);
    kick_ = std::make_unique<motion::SearchedKick>(first, worlds_.first().model, foot);
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
  double height = 0;
  Flight flight{place};
  const auto watchBall = [&] {
    flight.see(world.ball().pose.translation());
    if (contact < 0 && !world.ballTouchedBy().empty()) contact = cycles;
    height = std::max(height, world.ball().pose.translation().z());
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

  const BallRoll::Rest rest = ball_.roll(flying, [&](const Vec3& ball) { flight.see(ball); });
  motion::KickTry result;
  result.way = Eigen::Rotation2Dd(-ground.heading - direction_) * (rest.place - place);
  result.height = std::max(height, rest.height) - ballRadius;
  result.top = flight.top;
  result.milliseconds = milliseconds;
  result.error = walk.error();
  const double off = toDegrees(result.direction());
  TaskOutcome outcome;
  outcome.cost = options_.wish.cost(result);
  outcome.figures = {
      {"distance", result.way.x()}, {"direction", toDegrees(direction_) + off},
      {"off", std::abs(off)},       {"height", result.height},
      {"time", milliseconds},       {"contact", 1e3 * dt * (contact < 0 ? cycles : contact)},
      {"error", walk.error()},      {"up", walk.upright() ? 1.0 : 0.0},
      {"top", flight.top},          {"low", flight.came && flight.top < field.goalHeight ? 1.0 : 0.0}};
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
