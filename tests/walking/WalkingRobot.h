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

/// The parameters of a league robot type as the agent reads them: config/walking.yaml and the type's own
/// file.
inline WalkParameters readWalkParameters(int type) {
  const ConfigFile file("walking", {"config", "config/robots/type" + std::to_string(type)});
  WalkParameters parameters;
  for (const WalkParameterInfo& info : walkParameterTable())
    parameters.*info.value = file.root().get<double>(info.name, {info.low, info.high});
  file.checkUnknown();
  return parameters;
}

/// A robot in a world of its own that walks with the engine and senses with the league's resolution of 0.01
/// degrees and 0.01 m/s^2.
class WalkingRobot {
public:
  explicit WalkingRobot(int type) : WalkingRobot(type, readWalkParameters(type)) {}
  WalkingRobot(int type, const WalkParameters& parameters)
      : model(simsparkRobot(type)), local(model), engine(parameters, model), control(model) {
    restart();
  }

  /// Stands at a place of the field.
  void restart(const Pose2& place = {}) {
    engine.reset();
    control.reset();
    filter.reset();
    local.restart(place, engine.stand().angles);
    lastPose = pose();
    turned_ = 0;
  }

  /// One cycle; false when the robot lies.
  bool step(const WalkRequest& request) {
    WalkSensors sensors;
    const simulation::RobotReadings& sensed = local.sense();
    for (std::size_t j = 0; j < numJoints; ++j)
      sensors.angles[j] = rounded(sensed.angle[j], fromDegrees(0.01));
    Vec3 acc;
    for (int i = 0; i < 3; ++i) {
      sensors.gyro[i] = rounded(sensed.gyro[i], fromDegrees(0.01));
      acc[i] = rounded(sensed.acc[i], 0.01);
    }
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
    for (long i = std::lround(seconds / 0.02); i > 0; --i)
      if (!step(request)) return false;
    return true;
  }

  /// Place of the torso on the field.
  Pose2 pose() const {
    const Pose3 torso = local.torso().pose;
    return Pose2(Vec2(torso.translation().head<2>()), std::atan2(torso.linear()(1, 0), torso.linear()(0, 0)));
  }
  double turned() const { return turned_; }  ///< since the restart, without wrapping [rad]

  const RobotModel model;
  simulation::LocalRobot local;
  WalkEngine engine;
  WalkOutput output;
  Pose2 moved;  ///< in the last cycle

private:
  static double rounded(double value, double unit) { return std::round(value / unit) * unit; }

  JointVelocityControl control;
  TorsoAngleFilter filter;
  Pose2 lastPose;
  double turned_ = 0;
};

}  // namespace plumbline::walking
