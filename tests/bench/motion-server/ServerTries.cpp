#include "ServerTries.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "math/Angle.h"
#include "math/GroundPose.h"
#include "motion/MotionDefaults.h"
#include "training/tasks/BeforeKick.h"
#include "training/tasks/WalkOn.h"

namespace plumbline::bench {
namespace {

constexpr double dt = training::MotionDriver::dt;
constexpr int mostDraws = 50;       // until a start is as wanted
constexpr double spread = 0.01;     // of the ball's place [m]
constexpr double mostRolling = 20;  // [s]
constexpr double restSpeed = 0.02;  // [m/s]
constexpr int look = 10;            // cycles between two looks at whether the ball rests

bool walksOn(training::ServerTrial& trial, double fadeSeconds, const std::function<void()>& each) {
  training::WalkOn walk(trial);
  walk.begin(trial.player.angles(), fadeSeconds);
  while (!walk.isOver()) {
    walk.step();
    each();
  }
  return walk.upright();
}

}  // namespace

StandUpTries tryStandUp(training::ServerTrial& trial, const std::string& name, int direction, int tries,
                        std::uint64_t firstSeed, const Progress& progress) {
  const motion::KeyframeMotion motion = trial.motion(name);
  StandUpTries result;
  for (int i = 0; i < tries; ++i) {
    const std::uint64_t seed = firstSeed + static_cast<std::uint64_t>(i);
    for (int draw = 0;; ++draw) {
      if (draw == mostDraws) throw std::runtime_error("the robot does not fall as wanted");
      trial.seedStart(seed, draw);
      if (trial.fall(direction)) break;
    }
    trial.seedRun(seed);
    trial.elapsed = 0;
    trial.play(motion);
    result.milliseconds.push_back(1e3 * trial.elapsed);
    result.up.push_back(walksOn(trial, 0, [] {}));
    progress();
  }
  return result;
}

KickTries tryKick(training::ServerTrial& trial, const std::string& name, int tries, std::uint64_t firstSeed,
                  const Progress& progress) {
  const motion::KeyframeMotion kick = trial.motion(name);
  KickTries result;
  for (int i = 0; i < tries; ++i) {
    const std::uint64_t seed = firstSeed + static_cast<std::uint64_t>(i);
    for (int draw = 0;; ++draw) {
      if (draw == mostDraws) throw std::runtime_error("the robot does not come to rest before the ball");
      trial.standAt(training::kickPlace);
      trial.seedStart(seed, draw);
      if (training::comesToKick(trial)) break;
    }
    // Its place is known a few cycles later, and the ball is there as late.
    constexpr int late = 4;
    for (int cycle = 0; cycle < late; ++cycle) trial.step(trial.stand);
    trial.seedRun(seed);
    const double x = trial.random(-spread, spread), y = trial.random(-spread, spread);
    const Pose2 ground = groundPose(trial.torsoPose());
    const Vec2 place = ground * Vec2(kick.ball + Vec2(x, y));
    trial.robot.putBall(place);
    for (int cycle = 0; cycle < late; ++cycle) trial.step(trial.stand);

    Vec3 ball = trial.robot.ball();
    double height = 0;
    const auto watchBall = [&] {
      if (!trial.robot.playsOn()) return;  // the referee has put it elsewhere
      ball = trial.robot.ball();
      height = std::max(height, ball.z());
    };
    trial.player.start(kick, trial.readings().angle);
    while (!trial.player.finished()) {
      trial.player.step(dt, trial.still());
      trial.step(trial.player.angles());
      watchBall();
    }
    result.up.push_back(walksOn(trial, motion::walkFade, watchBall));
    Vec3 before = ball;
    for (int cycle = 1; cycle * dt < mostRolling && trial.robot.playsOn(); ++cycle) {
      trial.walkStep(Vec2::Zero(), 0, false);
      watchBall();
      if (cycle % look != 0) continue;
      if ((ball - before).norm() < restSpeed * look * dt) break;
      before = ball;
    }
    const Vec2 way = Eigen::Rotation2Dd(-ground.heading) * (ball.head<2>() - place);
    result.distance.push_back(way.x());
    result.direction.push_back(toDegrees(std::atan2(way.y(), way.x())));
    result.height.push_back(height);
    progress();
  }
  return result;
}

}  // namespace plumbline::bench
