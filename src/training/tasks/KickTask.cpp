#include "training/tasks/KickTask.h"

#include <cmath>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "math/Angle.h"
#include "simulation/Field.h"
#include "training/tasks/WalkOn.h"

namespace plumbline::training {
namespace {

constexpr double dt = motion::MotionTrial::dt;
constexpr double distanceWorth = 30, heightWorth = 120;  // formula 3.2
constexpr double placeSigma = 5;                         // [mm]
constexpr double fade = 0.06;                            // as WalkingEngine fades into the walk [s]
constexpr double walkedUp = 0.6;                         // share of the runs that begin with a walk
constexpr int cyclesToFly = 10;                          // after the motion, before the ball goes on alone
constexpr int mostStarts = 1000;
constexpr std::size_t startsKept = 4096;

/// Nothing stands in the way of a ball that is kicked forward from here [m].
const Pose2 begin(Vec2(-10, 5), 0);

int typeOf(const TaskOptions& options) {
  options.check({"type", "motion", "side", "distance", "spread", "weight", "steady"});
  return static_cast<int>(options.number("type", 0, 0, numSimsparkTypes() - 1));
}

Pose2 onGround(const Pose3& torso) {
  return Pose2(Vec2(torso.translation().head<2>()), std::atan2(torso.linear()(1, 0), torso.linear()(0, 0)));
}

}  // namespace

KickTask::KickTask(const TaskOptions& options)
    : right_(options.word("side", "right", {"right", "left"}) == "right"),
      distance_(options.number("distance", 0, 0, 30)),
      spread_(options.number("spread", 0.01, 0, 0.1)),
      weight_(options.number("weight", 0.08, 0, 100)),
      steady_(options.number("steady", 1, 0, 100)),
      trial_(typeOf(options)) {
  try {
    first_ = trial_.motion(options.word("motion", "kickRight"));
  } catch (const std::out_of_range& error) {
    throw ConfigurationError(std::string("option motion: ") + error.what());
  }
  if (first_.ball == Vec2::Zero())
    throw ConfigurationError("option motion: " + first_.name + " is no kick: it has no ball");
  if ((first_.ball.y() < 0) != right_) first_ = mirrored(first_);
  // What is searched is for one place of the ball; a shift with it would be judged together with the spread.
  first_.ballReach = Vec2::Zero();
  for (motion::Keyframe& frame : first_.keyframes) frame.ballGains.clear();
  motion_ = std::make_unique<MotionParameters>(first_, trial_.model, Sides::apart);
  list_ = motion_->list();
  const Vec2 place = 1e3 * first_.ball;
  list_.push_back({"ballX", place.x(), 100, 300, placeSigma});
  list_.push_back({"ballY", place.y(), right_ ? -150.0 : -20.0, right_ ? 20.0 : 150.0, placeSigma});
}

/// Walks somewhere near forward and stops, as before a kick in a game. False: fell or does not stop.
bool KickTask::walkUp() {
  trial_.robot.restart(begin, trial_.stand);
  trial_.restarted();
  const Vec2 velocity(trial_.random(-0.05, 0.35), trial_.random(-0.1, 0.1));
  const double turn = trial_.random(-0.4, 0.4), seconds = trial_.random(0.8, 1.6);
  for (double t = 0; t < seconds; t += dt) trial_.walkStep((1 - 0.7 * t / seconds) * velocity, turn);
  for (int i = 0; i < 100; ++i)
    if (trial_.walkStep(Vec2::Zero(), 0, false)) return !trial_.lying() && trial_.tilt() < 0.5;
  return false;
}

/// Stands and comes to rest from a lean of up to two degrees.
bool KickTask::sway() {
  trial_.robot.restart(begin, trial_.stand);
  trial_.restarted();
  JointArray leaning = trial_.stand;
  const double roll = trial_.random(-0.035, 0.035), pitch = trial_.random(-0.035, 0.035);
  for (const JointId joint : {lHipRoll, rHipRoll}) leaning[joint] += roll;
  for (const JointId joint : {lAnkleRoll, rAnkleRoll}) leaning[joint] -= roll;
  for (const JointId joint : {lAnklePitch, rAnklePitch}) leaning[joint] += pitch;
  const int rest = 3 + static_cast<int>(trial_.random(0, 8));
  for (int i = 0; i < 5; ++i) trial_.step(leaning);
  for (int i = 0; i < rest; ++i) trial_.step(trial_.stand);
  return trial_.tilt() < 0.5;
}

const KickTask::Start& KickTask::start(std::uint64_t seed) {
  if (const auto found = started_.find(seed); found != started_.end()) return found->second;
  if (started_.size() >= startsKept) started_.clear();
  for (int i = 0; i < mostStarts; ++i) {
    trial_.seed(static_cast<unsigned>(seed * 2654435761U + static_cast<unsigned>(i)));
    if (!(trial_.random(0, 1) < walkedUp ? walkUp() : sway())) continue;
    Start start;
    const JointArray before = trial_.robot.sense().angle;
    trial_.step(trial_.stand);
    start.torso = trial_.robot.torso();
    start.angles = trial_.robot.sense().angle;
    for (std::size_t j = 0; j < numJoints; ++j) start.rates[j] = (start.angles[j] - before[j]) / dt;
    return started_[seed] = start;
  }
  throw std::runtime_error("the robot does not stand before the kick");
}

TaskOutcome KickTask::tryMotion(const motion::KeyframeMotion& kick, std::uint64_t seed) {
  const Start from = start(seed);
  simulation::LocalRobot& robot = trial_.robot;
  robot.restart(from.torso.pose, from.angles);
  simulation::World& world = robot.world();
  world.setState(robot.robot(), from.torso, from.angles, from.rates);
  trial_.restarted();
  trial_.seed(static_cast<unsigned>(seed * 2246822519U + 1));
  const double x = trial_.random(-spread_, spread_), y = trial_.random(-spread_, spread_);
  const Pose2 ground = onGround(from.torso.pose);
  const Vec2 place = ground * Vec2(kick.ball + Vec2(x, y));
  world.setBall(Vec3(place.x(), place.y(), simulation::ballRadius), Vec3::Zero());
  WalkOn walk(trial_);

  int cycles = 0, contact = -1;
  double height = 0;
  const auto watchBall = [&] {
    if (contact < 0 && !world.ballTouchedBy().empty()) contact = cycles;
    height = std::max(height, world.ball().pose.translation().z());
  };
  trial_.player.start(kick, robot.sense().angle);
  bool still = false;
  for (; !trial_.player.finished(); ++cycles) {
    trial_.player.step(dt, still);
    trial_.step(trial_.player.angles());
    watchBall();
    still = trial_.still();
  }
  const double milliseconds = 1e3 * cycles * dt;
  walk.begin(trial_.player.angles(), fade);
  for (int i = 0; i < cyclesToFly; ++i, ++cycles) {
    walk.step();
    watchBall();
  }
  const simulation::BodyState flying = world.ball();
  while (!walk.isOver()) walk.step();

  const BallRoll::Rest rest = ball_.roll(flying);
  height = std::max(height, rest.height) - simulation::ballRadius;
  const Vec2 way = Eigen::Rotation2Dd(-ground.heading) * (rest.place - place);
  const double direction = way.norm() > 0.1 ? toDegrees(std::atan2(way.y(), way.x())) : 0;
  TaskOutcome outcome;
  outcome.cost = distanceWorth * std::abs(way.y()) + steady_ * walk.error() + weight_ * milliseconds;
  if (distance_ > 0)
    outcome.cost += distanceWorth * std::abs(way.x() - distance_);
  else
    outcome.cost -= distanceWorth * way.x() + heightWorth * std::min(1.0, height);
  outcome.figures = {{"distance", way.x()},
                     {"direction", direction},
                     {"off", std::abs(direction)},
                     {"height", height},
                     {"time", milliseconds},
                     {"contact", 1e3 * dt * (contact < 0 ? cycles : contact)},
                     {"error", walk.error()},
                     {"up", walk.upright() ? 1.0 : 0.0}};
  return outcome;
}

motion::KeyframeMotion KickTask::motionOf(const Eigen::VectorXd& parameters) const {
  const Eigen::Index n = parameters.size() - 2;
  motion::KeyframeMotion kick = motion_->written(parameters.head(n), dt);
  kick.ball = Vec2(std::round(parameters[n]) / 1e3, std::round(parameters[n + 1]) / 1e3);
  kick.kick.reset();
  return kick;
}

TaskOutcome KickTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  return tryMotion(motionOf(parameters), seed);
}

std::string KickTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                           const std::map<std::string, double>& figures) const {
  motion::KeyframeMotion kick = motionOf(parameters);
  if (!figures.empty())
    kick.kick = motion::KickEffect{figures.at("distance"), fromDegrees(figures.at("direction")),
                                   1e-3 * figures.at("contact")};
  return motionFile(kick, heading);
}

MAKE_TASK(kick, {"kick", "a kick: type, motion, side, distance, spread, weight, steady",
                 [](const TaskOptions& options) -> std::unique_ptr<SearchTask> {
                   return std::make_unique<KickTask>(options);
                 }});

}  // namespace plumbline::training
