#include "training/tasks/DiveTask.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "tactics/RollingBall.h"

namespace plumbline::training {
namespace {

constexpr double leastShot = 2, mostShot = 5;        // distance of the shot [m]
constexpr double leastArrival = 1, mostArrival = 3;  // speed of a ball that nothing stops, at the robot [m/s]
constexpr double sliding = 1.4;     // a ball that slides before it rolls loses 2/7 of its speed
constexpr double mostAcross = 0.3;  // metres that a shot goes aside in each metre that it comes nearer
constexpr double mostRise = 2.5;    // upward speed of a shot [m/s]
constexpr double crossing = 0.05;   // a ball so near before the robot crosses [m]
constexpr double behind = 0.25;     // a ball so far behind the robot is a goal [m]
constexpr double mostWatched = 3;   // [s]
constexpr double halfTorso = 0.2;   // its length, of a robot that lies on its side [m]
constexpr double hint = 0.1;        // cost of a body that covers nothing of the way
constexpr int cyclesBefore = 10;    // of standing, before the shot
const Vec2 keeperPlace(-5, 0);      // nothing else stands near

}  // namespace

DiveTask::DiveTask(const DiveOptions& options)
    : worlds_(options.world), reaction_(options.reaction), from_(options.from), to_(options.to) {
  try {
    const MotionTrial& trial = worlds_.first();
    parameters_ = std::make_unique<motion::MotionParameters>(trial.motion(options.motion), trial.model,
                                                             motion::Sides::apart);
  } catch (const std::out_of_range& error) {
    throw ConfigurationError(std::string("option motion: ") + error.what());
  }
}

TaskOutcome DiveTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  const motion::KeyframeMotion dive = parameters_->written(parameters, MotionTrial::dt);
  MotionTrial& trial = worlds_.of(seed);
  trial.seedStart(seed);
  trial.robot.restart(Pose2(keeperPlace, 0), trial.stand);
  trial.restarted();
  for (int i = 0; i < cyclesBefore; ++i) trial.step(trial.stand);

  simulation::World& world = trial.robot.world();
  const double aside = trial.random(from_, to_), distance = trial.random(leastShot, mostShot);
  const double speed = sliding * (trial.random(leastArrival, mostArrival) + distance / ballRollingSeconds);
  const double across = trial.random(-mostAcross, mostAcross),
               rise = trial.random(0, 1) < 0.5 ? 0 : trial.random(0, mostRise);
  const double radius = simulation::WorldConfig().field.ballRadius;
  const Vec2 from = keeperPlace + Vec2(distance, aside + distance * across);
  const Vec2 way = Vec2(-distance, -distance * across).normalized();
  world.setBall(Vec3(from.x(), from.y(), radius), Vec3(speed * way.x(), speed * way.y(), rise));

  double cover = 0;
  bool crossed = false, still = false, goal = false;
  trial.player.start(dive, trial.robot.sense().angle);
  for (double t = 0; t < mostWatched && !goal; t += MotionTrial::dt) {
    if (t < reaction_) {
      trial.step(trial.stand);
    } else {
      trial.player.step(MotionTrial::dt, still);
      trial.step(trial.player.angles());
      still = trial.still();
    }
    const Vec3 ball = world.ball().pose.translation();
    if (!crossed && ball.x() < keeperPlace.x() + crossing) {
      crossed = true;
      const Pose3 torso = trial.robot.torso().pose;
      cover = std::clamp(
          torso.translation().y() - keeperPlace.y() + halfTorso * std::abs(torso.linear()(1, 2)), 0.0, aside);
    }
    goal = ball.x() < keeperPlace.x() - behind;
  }
  TaskOutcome outcome;
  outcome.cost = (goal ? 1 : 0) - hint * cover / std::max(aside, 0.1);
  outcome.figures = {{"saved", goal ? 0.0 : 1.0}, {"cover", cover}};
  return outcome;
}

std::string DiveTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                           const std::map<std::string, double>&) const {
  return motion::motionFile(parameters_->written(parameters, MotionTrial::dt), worlds_.first().model,
                            heading);
}

MAKE_TASK(DiveTask, "dive", "a goalie's dive to the left")

}  // namespace plumbline::training
