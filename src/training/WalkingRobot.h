#pragma once
#include <cmath>
#include <string>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "math/Angle.h"
#include "math/TorsoAngleFilter.h"
#include "robot/JointVelocityControl.h"
#include "simspark/LeagueRobots.h"
#include "simulation/league/LocalRobot.h"
#include "training/FeltFeet.h"
#include "training/Walker.h"

namespace plumbline::training {

/// The walk of a league robot type as the agent reads it: config/walking.yaml and the type's own file.
inline walking::WalkGaits readLeagueGaits(int type) {
  const ConfigFile file("walking", {configFolder(), configPath("robots/" + simsparkRobotName(type))});
  walking::WalkGaits gaits = walking::readWalkGaits(file.root());
  file.checkUnknown();
  return gaits;
}

/// The common walk of config/walking.yaml alone: slow and in open loop, fitted to no robot.
inline walking::WalkGaits plainWalk() {
  const ConfigFile file("walking", {configFolder()});
  const walking::WalkGaits gaits = walking::readWalkGaits(file.root());
  file.checkUnknown();
  return gaits;
}

/// The same walk in open loop: nothing measured has an effect.
inline walking::WalkGaits withoutFeedback(walking::WalkGaits gaits) {
  gaits.openLoop();
  return gaits;
}

/// A robot of the league in a world of its own; it senses with the league's resolution of 0.01 degrees and
/// 0.01 m/s^2.
class WalkingRobot : public Walker {
public:
  explicit WalkingRobot(int type) : WalkingRobot(type, readLeagueGaits(type)) {}
  /// config: of its world, effects among it.
  WalkingRobot(int type, const walking::WalkGaits& gaits, const simulation::WorldConfig& config = {})
      : Walker(simsparkRobot(type), gaits, 0.02), local(model, config), control_(model) {
    restart();
  }

  /// Changes the velocity of the whole body at once, as a push on its centre of mass does.
  void push(const Vec3& change) override {
    simulation::BodyState torso = local.torso();
    torso.linearVelocity += change;
    local.world().setVelocities(local.robot(), torso, rates());
  }

  Pose3 torso() const override { return local.torso().pose; }
  Vec2 comVelocity() override {
    Vec3 momentum = Vec3::Zero();
    double mass = 0;
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      momentum +=
          model.links[i].mass * local.world().linkState(local.robot(), static_cast<int>(i)).linearVelocity;
      mass += model.links[i].mass;
    }
    return Eigen::Rotation2Dd(-pose().heading) * Vec2(momentum.head<2>() / mass);
  }

  simulation::LocalRobot local;

private:
  void put(const Pose2& place, const JointArray& angles) override {
    control_.reset();
    filter_.reset();
    local.restart(place, angles);
    lastAngles_ = local.sense().angle;
  }
  void move(const Vec2& place) override {
    simulation::BodyState torso = local.torso();
    torso.pose.translation().head<2>() = place;
    local.world().setState(local.robot(), torso, local.sense().angle, rates());
  }
  walking::WalkSensors sense() override {
    walking::WalkSensors sensors;
    const simulation::RobotReadings& sensed = local.sense();
    lastAngles_ = sensed.angle;
    for (std::size_t j = 0; j < maxJoints; ++j)
      sensors.angles[j] = rounded(sensed.angle[j], fromDegrees(0.01));
    Vec3 acc;
    for (int i = 0; i < 3; ++i) {
      sensors.gyro[i] = rounded(sensed.gyro[i], fromDegrees(0.01));
      acc[i] = rounded(sensed.acc[i], 0.01);
    }
    sensors.feet = feltFeet(sensed);
    filter_.update(sensors.gyro, acc, sensors.dt);
    sensors.torsoAngles = Vec2(filter_.roll(), filter_.pitch());
    return sensors;
  }
  void act(const walking::WalkOutput& output, const walking::WalkSensors& sensors) override {
    local.act(control_.update(sensors.angles, lookingAround(output.angles, local.time()), sensors.dt));
  }
  /// As the league's server prints it.
  JointArray rates() const {
    JointArray rates{};
    for (std::size_t j = 0; j < maxJoints; ++j) rates[j] = (local.sense().angle[j] - lastAngles_[j]) / cycle;
    return rates;
  }
  static double rounded(double value, double unit) { return std::round(value / unit) * unit; }

  JointVelocityControl control_;
  TorsoAngleFilter filter_;
  JointArray lastAngles_{};
};

}  // namespace plumbline::training
