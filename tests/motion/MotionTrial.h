#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "framework/ConfigFile.h"
#include "motion/KeyframePlayer.h"
#include "motion/KeyframeReader.h"
#include "robot/JointVelocityControl.h"
#include "simspark/LeagueRobots.h"
#include "simulation/LocalRobot.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline::motion {

/// One robot of a league type in a world of its own with the motions and the walk of config/, moved as the
/// agent moves it: targets through the joint control, one cycle of delay, angles as the server rounds them.
/// For tests and benchmarks of motions.
class MotionTrial {
public:
  static constexpr double dt = 0.02;

  explicit MotionTrial(int type)
      : model(simsparkRobot(type)),
        robot(model),
        control(model),
        walk(readWalkGaits(type), model),
        stand(walk.stand().angles),
        motions(readMotions(motionDirectories(type), model)) {
    robot.restart(Pose2(), stand);
    standingHeight = robot.torso().pose.translation().z();
  }

  static std::vector<std::string> directories(int type) {
    return {"config", "config/robots/type" + std::to_string(type)};
  }
  static std::vector<std::filesystem::path> motionDirectories(int type) {
    std::vector<std::filesystem::path> paths;
    for (const std::string& directory : directories(type)) paths.emplace_back(directory + "/motions");
    return paths;
  }
  static walking::WalkGaits readWalkGaits(int type) {
    return walking::readWalkGaits(ConfigFile("walking", directories(type)).root());
  }

  const KeyframeMotion& motion(const std::string& name) const {
    for (const KeyframeMotion& motion : motions)
      if (motion.name == name) return motion;
    throw std::out_of_range("no motion " + name);
  }

  /// Uniform in [low, high]; the same on every machine.
  double random(double low, double high) { return low + (high - low) * (generator() / 4294967296.0); }
  void seed(unsigned value) { generator.seed(value); }

  Vec3 up() const { return robot.torso().pose.linear().row(2).transpose(); }
  double tilt() const { return std::acos(std::clamp(up().z(), -1.0, 1.0)); }
  double height() const { return robot.torso().pose.translation().z(); }

  void step(const JointArray& targets) {
    JointArray measured = robot.sense().angle;
    for (double& angle : measured) angle = std::round(angle * 18000 / pi) / (18000 / pi);
    robot.act(control.update(measured, targets, dt));
    // As FallDetector and Stillness see it.
    tiltedCycles = tilt() > 1.05 ? tiltedCycles + 1 : 0;
    stillCycles = robot.sense().gyro.norm() < 0.3 ? stillCycles + 1 : 0;
  }
  bool lying() const { return tiltedCycles >= 5; }

  /// Throws the robot over: it is put down tilted forward (1), backward (-1) or sideways (0), with its joints
  /// anywhere near the walk's and moving, and falls until it has lain for a moment. False if it did not fall.
  bool fall(int direction) {
    JointArray from = jitter(0.25), to = jitter(0.4);
    double pitch = direction * random(0.35, 1.45), roll = random(-0.35, 0.35);
    if (direction == 0) {
      pitch = random(-0.3, 0.3);
      roll = (random(0, 1) < 0.5 ? -1 : 1) * random(0.5, 1.4);
    }
    const double heading = random(-pi, pi);
    robot.restart(
        translation(0, 0, random(0.30, 0.42)) * rotationZ(heading) * rotationY(pitch) * rotationX(roll),
        from);
    restarted();
    const int rest = static_cast<int>(random(0, 10));
    for (int i = 0; i < 200 && !lying(); ++i) step(to);
    for (int i = 0; i < rest; ++i) step(to);
    return lying();
  }

  /// Plays the motion; false if the robot lay down meanwhile and stopAtFall is set.
  bool play(const KeyframeMotion& motion, bool stopAtFall = false) {
    player.start(motion, robot.sense().angle);
    while (!player.finished()) {
      player.step(dt, stillCycles >= 3);
      step(player.angles());
      elapsed += dt;
      if (stopAtFall && lying()) return false;
    }
    return true;
  }
  /// Fades from the last motion into the stand and holds it.
  void standStill(double seconds) {
    const JointArray from = player.angles();
    for (double t = dt; t < seconds + dt / 2; t += dt) {
      const double share = std::min(1.0, t / 0.14);
      JointArray targets = stand;
      for (std::size_t j = 0; j < numJoints; ++j) targets[j] = (1 - share) * from[j] + share * stand[j];
      step(targets);
      elapsed += dt;
    }
  }
  /// Walks; false as soon as the robot lies.
  bool walkFor(double seconds, const Vec2& velocity, double turn) {
    walk.reset();
    for (double t = 0; t < seconds; t += dt) {
      walking::WalkSensors sensors;
      sensors.angles = robot.sense().angle;
      const Vec3 u = up();
      sensors.torsoAngles = Vec2(std::atan2(u.y(), u.z()), std::atan2(-u.x(), u.z()));
      sensors.gyro = robot.sense().gyro;
      step(walk.update({velocity, turn, true}, sensors).angles);
      if (lying()) return false;
    }
    return true;
  }
  /// The stand-up action the selector would choose for how the robot lies now.
  const KeyframeMotion& standUpMotion() const {
    const Vec3 u = up();
    if (std::abs(u.x()) < std::abs(u.y())) return motion("rollOver");
    return motion(u.x() < 0 ? "standUpFront" : "standUpBack");
  }

  RobotModel model;
  simulation::LocalRobot robot;
  JointVelocityControl control;
  walking::WalkEngine walk;
  JointArray stand;
  std::vector<KeyframeMotion> motions;
  KeyframePlayer player;
  double standingHeight = 0;  ///< of the torso [m]
  double elapsed = 0;         ///< in motions since it was set to 0 [s]

  void restarted() {
    control.reset();
    tiltedCycles = stillCycles = 0;
  }

private:
  JointArray jitter(double size) {
    JointArray angles = stand;
    for (int j = lShoulderPitch; j < numJoints; ++j) {
      const auto joint = static_cast<JointId>(j);
      if (!model.has(joint)) continue;
      const Link& link = model.linkMovedBy(joint);
      angles[joint] = std::clamp(angles[joint] + random(-size, size), link.lower + 0.02, link.upper - 0.02);
    }
    return angles;
  }

  std::mt19937 generator{1};
  int tiltedCycles = 0, stillCycles = 0;
};

struct StandUpResult {
  bool up = false;
  int tries = 0;
  double seconds = 0;   ///< from lying to up for good, repeats included
  bool walked = false;  ///< walked on at once for two seconds
};

/// Falls and stands up, repeating it for up to maxSeconds; then walks in some direction. Nothing if the robot
/// did not fall.
inline std::optional<StandUpResult> standUpTrial(MotionTrial& trial, int direction, unsigned seed,
                                                 double maxSeconds = 12) {
  trial.seed(seed);
  if (!trial.fall(direction)) return std::nullopt;
  StandUpResult result;
  trial.elapsed = 0;
  while (!result.up && trial.elapsed < maxSeconds) {
    ++result.tries;
    trial.play(trial.standUpMotion());
    if (trial.lying()) continue;
    result.seconds = trial.elapsed;
    trial.standStill(0.5);  // falling over again belongs to the try
    result.up = trial.tilt() < 0.45 && trial.height() > 0.85 * trial.standingHeight;
  }
  if (!result.up) return result;
  const double angle = trial.random(-pi, pi);
  result.walked = trial.walkFor(2, 0.15 * Vec2(std::cos(angle), std::sin(angle)), trial.random(-0.5, 0.5));
  return result;
}

struct KickResult {
  double distance = 0;  ///< forward [m]
  double angle = 0;     ///< [rad]
  double seconds = 0;   ///< of the kick
  bool fell = false;
};

/// Kicks a ball that lies within `tolerance` [m] of where the kick expects it; the robot sways a little, as
/// after a stop of the walk.
inline KickResult kickTrial(MotionTrial& trial, Side foot, double tolerance, unsigned seed) {
  trial.seed(seed);
  trial.robot.restart(Pose2(), trial.stand);
  trial.restarted();
  JointArray sway = trial.stand;
  const double roll = trial.random(-0.035, 0.035), pitch = trial.random(-0.035, 0.035);
  for (const JointId joint : {lHipRoll, rHipRoll}) sway[joint] += roll;
  for (const JointId joint : {lAnkleRoll, rAnkleRoll}) sway[joint] -= roll;
  for (const JointId joint : {lAnklePitch, rAnklePitch}) sway[joint] += pitch;
  for (int i = 0; i < 5; ++i) trial.step(sway);
  const int rest = 3 + static_cast<int>(trial.random(0, 8));
  for (int i = 0; i < rest; ++i) trial.step(trial.stand);

  const KeyframeMotion right = trial.motion("kickRight");
  const KeyframeMotion kick = foot == Side::right ? right : mirrored(right);
  const Pose3 torso = trial.robot.torso().pose;
  const Pose2 ground(torso.translation().x(), torso.translation().y(),
                     std::atan2(torso.linear()(1, 0), torso.linear()(0, 0)));
  const Vec2 ball =
      kick.ball + Vec2(trial.random(-tolerance, tolerance), trial.random(-tolerance, tolerance));
  const Vec2 place = ground * ball;
  simulation::World& world = trial.robot.world();
  world.setBall(Vec3(place.x(), place.y(), 0.042), Vec3::Zero());
  KickResult result;
  trial.elapsed = 0;
  result.fell = !trial.play(shiftedToBall(kick, ball), true);
  result.seconds = trial.elapsed;
  trial.standStill(2);
  result.fell = result.fell || trial.tilt() > 0.5;
  for (int i = 0; i < 500 && world.ball().linearVelocity.norm() > 0.08; ++i) trial.step(trial.stand);
  const Vec2 way = ground.inverse() * Vec2(world.ball().pose.translation().head<2>()) - ball;
  result.distance = way.x();
  result.angle = way.norm() > 0.05 ? std::atan2(way.y(), way.x()) : 0;
  return result;
}

}  // namespace plumbline::motion
