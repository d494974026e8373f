#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "motion/KeyframePlayer.h"
#include "motion/KeyframeReader.h"
#include "robot/JointVelocityControl.h"
#include "simspark/LeagueRobots.h"
#include "simulation/league/LocalRobot.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline::motion {

/// One robot of a league type in its own world with the motions and the walk of config/. It is controlled as
/// by the agent: targets through the joint control, one cycle of delay, angles rounded as by the server. For
/// searches, tests and benchmarks of motions.
class MotionTrial {
public:
  static constexpr double dt = 0.02;

  /// config: of its world, effects among it.
  explicit MotionTrial(int type, const simulation::WorldConfig& config = {})
      : model(simsparkRobot(type)),
        robot(model, config),
        control(model),
        gaits(readWalkGaits(type)),
        walk(gaits, model),
        stand(walk.stand().angles),
        motions(readMotions(motionDirectories(type), model)) {
    robot.restart(Pose2(), stand);
    standingHeight = robot.torso().pose.translation().z();
  }

  static std::vector<std::string> directories(int type) {
    return {configFolder(), configPath("robots/type" + std::to_string(type))};
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
  double random(double low, double high) { return low + (high - low) * (generator_() / 4294967296.0); }
  void seed(unsigned value) { generator_.seed(value); }

  Vec3 up() const { return robot.torso().pose.linear().row(2).transpose(); }
  double tilt() const { return std::acos(std::clamp(up().z(), -1.0, 1.0)); }
  double height() const { return robot.torso().pose.translation().z(); }

  void step(const JointArray& targets) {
    JointArray measured = robot.sense().angle;
    for (double& angle : measured) angle = std::round(angle * 18000 / pi) / (18000 / pi);
    robot.act(control.update(measured, targets, dt));
    // As FallDetector and Stillness see it.
    tiltedCycles_ = tilt() > 1.05 ? tiltedCycles_ + 1 : 0;
    stillCycles_ = robot.sense().gyro.norm() < 0.3 ? stillCycles_ + 1 : 0;
  }
  bool lying() const { return tiltedCycles_ >= 5; }
  /// The torso does not turn: what a wait to settle waits for.
  bool still() const { return stillCycles_ >= 3; }

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
      player.step(dt, still());
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
      for (std::size_t j = 0; j < maxJoints; ++j) targets[j] = (1 - share) * from[j] + share * stand[j];
      step(targets);
      elapsed += dt;
    }
  }
  /// Walks; false as soon as the robot lies.
  bool walkFor(double seconds, const Vec2& velocity, double turn) {
    beginWalk();
    for (double t = 0; t < seconds; t += dt) {
      walkStep(velocity, turn);
      if (lying()) return false;
    }
    return true;
  }
  void beginWalk() { walk.reset(); }
  /// One cycle of the walk, whether it stands or lies; go: false comes to a stop. True once it stands.
  bool walkStep(const Vec2& velocity, double turn, bool go = true) {
    const walking::WalkOutput output = walkOutput(velocity, turn, go);
    step(output.angles);
    return output.standing;
  }
  /// What the walk wants in this cycle; the caller moves the robot.
  walking::WalkOutput walkOutput(const Vec2& velocity, double turn, bool go = true) {
    walking::WalkSensors sensors;
    sensors.angles = robot.sense().angle;
    const Vec3 u = up();
    sensors.torsoAngles = Vec2(std::atan2(u.y(), u.z()), std::atan2(-u.x(), u.z()));
    sensors.gyro = robot.sense().gyro;
    sensors.feet = walking::feltFeet(robot.sense(), felt);
    return walk.update({velocity, turn, go}, sensors);
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
  walking::WalkGaits gaits;
  walking::WalkEngine walk;
  JointArray stand;
  std::vector<KeyframeMotion> motions;
  KeyframePlayer player;
  double standingHeight = 0;  ///< of the torso [m]
  double elapsed = 0;         ///< in motions since it was set to 0 [s]

  /// After the robot was put somewhere: nothing of what was before has an effect from now on.
  void restarted() {
    control.reset();
    walk =
        walking::WalkEngine(gaits, model);  // its reset() keeps what it learnt and the foot of its first step
    tiltedCycles_ = stillCycles_ = 0;
  }

private:
  static std::optional<walking::FootContact> felt(const std::optional<simulation::FootForce>& force) {
    if (!force) return std::nullopt;
    return walking::FootContact{force->point, force->force};
  }
  JointArray jitter(double size) {
    JointArray angles = stand;
    for (int j = lShoulderPitch; j < maxJoints; ++j) {
      const auto joint = static_cast<JointId>(j);
      if (!model.has(joint)) continue;
      const Link& link = model.linkMovedBy(joint);
      angles[joint] = std::clamp(angles[joint] + random(-size, size), link.lower + 0.02, link.upper - 0.02);
    }
    return angles;
  }

  std::mt19937 generator_{1};
  int tiltedCycles_ = 0, stillCycles_ = 0;
};

}  // namespace plumbline::motion
