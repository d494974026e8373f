#pragma once
#include <cmath>
#include <string>

#include "framework/ConfigFile.h"
#include "math/Angle.h"
#include "math/TorsoAngleFilter.h"
#include "robot/JointVelocityControl.h"
#include "simulation/LocalRobot.h"
#include "walking/WalkEngine.h"

namespace plumbline::walking {

/// The walk of a league robot type as the agent reads it: config/walking.yaml and the type's own file.
inline WalkGaits readWalkGaits(int type) {
  const ConfigFile file("walking", {"config", "config/robots/type" + std::to_string(type)});
  WalkGaits gaits = readWalkGaits(file.root());
  file.checkUnknown();
  return gaits;
}

/// The common walk of config/walking.yaml alone: slow and in open loop, fitted to no robot.
inline WalkGaits plainWalk() {
  const ConfigFile file("walking", {"config"});
  return readWalkGaits(file.root());
}

/// The same walk in open loop: nothing measured has an effect.
inline WalkGaits withoutFeedback(WalkGaits gaits) {
  const auto open = [](WalkParameters& p) {
    for (const WalkParameterInfo& info : walkParameterTable()) {
      const std::string name = info.name;
      const bool gain = name.ends_with("Gain") || name.ends_with("Rate") ||
                        name.starts_with("observationP") || name.starts_with("observationV") ||
                        name == "swingLevel" || name == "tiltBrake" || name == "torsoMeasured";
      if (gain) p.*info.value = 0;
    }
  };
  open(gaits.base);
  for (WalkParameters& corner : gaits.corner) open(corner);
  return gaits;
}

/// A robot in a world of its own that walks with the engine and senses with the league's resolution of 0.01
/// degrees and 0.01 m/s^2.
class WalkingRobot {
public:
  explicit WalkingRobot(int type) : WalkingRobot(type, readWalkGaits(type)) {}
  WalkingRobot(int type, const WalkGaits& gaits)
      : model(simsparkRobot(type)), local(model), engine(gaits, model), control(model) {
    restart();
  }
  /// Walks with other parameters from now on, standing.
  void use(const WalkGaits& gaits) {
    engine = WalkEngine(gaits, model);
    restart();
  }

  /// Stands at a place of the field.
  void restart(const Pose2& place = {}) {
    engine.reset();
    control.reset();
    filter.reset();
    local.restart(place, engine.stand().angles);
    lastPose = pose();
    lastAngles = local.sense().angle;
    turned_ = 0;
  }

  /// One cycle; false when the robot lies.
  bool step(const WalkRequest& request) {
    WalkSensors sensors;
    const simulation::RobotReadings& sensed = local.sense();
    lastAngles = sensed.angle;
    for (std::size_t j = 0; j < numJoints; ++j)
      sensors.angles[j] = rounded(sensed.angle[j], fromDegrees(0.01));
    Vec3 acc;
    for (int i = 0; i < 3; ++i) {
      sensors.gyro[i] = rounded(sensed.gyro[i], fromDegrees(0.01));
      acc[i] = rounded(sensed.acc[i], 0.01);
    }
    sensors.feet = feltFeet(sensed);
    filter.update(sensors.gyro, acc, sensors.dt);
    sensors.torsoAngles = Vec2(filter.roll(), filter.pitch());
    output = engine.update(request, sensors);
    // The head looks around.
    output.angles[headYaw] = 1.2 * std::sin(2 * local.time());
    output.angles[headPitch] = 0.3 * std::sin(3.1 * local.time());
    local.act(control.update(sensors.angles, output.angles, sensors.dt));

    const Pose2 now = pose();
    moved = lastPose.inverse() * now;
    turned_ += moved.heading;
    lastPose = now;
    return !local.fallen();
  }
  /// Many cycles; false as soon as the robot lies.
  bool run(const WalkRequest& request, double seconds) {
    for (long i = std::lround(seconds / cycleSeconds); i > 0; --i)
      if (!step(request)) return false;
    return true;
  }

  /// Goes on walking at another place, heading as before.
  void carry(const Vec2& place) {
    simulation::BodyState torso = local.torso();
    torso.pose.translation().head<2>() = place;
    local.world().setState(local.robot(), torso, local.sense().angle, rates());
    lastPose = pose();
  }
  /// Changes the velocity of the whole body at once, as a push on its centre of mass does [m/s, world].
  void push(const Vec3& change) {
    simulation::BodyState torso = local.torso();
    torso.linearVelocity += change;
    local.world().setVelocities(local.robot(), torso, rates());
  }

  /// Place of the torso on the field.
  Pose2 pose() const {
    const Pose3 torso = local.torso().pose;
    return Pose2(Vec2(torso.translation().head<2>()), std::atan2(torso.linear()(1, 0), torso.linear()(0, 0)));
  }
  /// True velocity of the centre of mass over the ground, in the torso's heading [m/s].
  Vec2 comVelocity() {
    Vec3 momentum = Vec3::Zero();
    double mass = 0;
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      momentum +=
          model.links[i].mass * local.world().linkState(local.robot(), static_cast<int>(i)).linearVelocity;
      mass += model.links[i].mass;
    }
    return Eigen::Rotation2Dd(-pose().heading) * Vec2(momentum.head<2>() / mass);
  }
  double turned() const { return turned_; }  ///< since the restart, without wrapping [rad]

  const RobotModel model;
  simulation::LocalRobot local;
  WalkEngine engine;
  WalkOutput output;
  Pose2 moved;  ///< in the last cycle

private:
  /// As the league's server prints it.
  static FootSensors feltFeet(const simulation::RobotReadings& sensed) {
    const auto felt = [](const std::optional<simulation::FootForce>& f) -> std::optional<FootContact> {
      if (!f) return std::nullopt;
      const auto printed = [](const Vec3& v) {
        return Vec3(v.unaryExpr([](double x) { return rounded(x, 0.01); }));
      };
      return FootContact{printed(f->point), printed(f->force)};
    };
    FootSensors feet;
    feet.foot = {felt(sensed.leftFoot), felt(sensed.rightFoot)};
    feet.toe = {felt(sensed.leftToe), felt(sensed.rightToe)};
    return feet;
  }
  JointArray rates() const {
    JointArray rates{};
    for (std::size_t j = 0; j < numJoints; ++j)
      rates[j] = (local.sense().angle[j] - lastAngles[j]) / cycleSeconds;
    return rates;
  }
  static constexpr double cycleSeconds = 0.02;
  static double rounded(double value, double unit) { return std::round(value / unit) * unit; }

  JointVelocityControl control;
  TorsoAngleFilter filter;
  Pose2 lastPose;
  JointArray lastAngles{};
  double turned_ = 0;
};

}  // namespace plumbline::walking
