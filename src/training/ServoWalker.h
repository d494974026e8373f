#pragma once
#include <functional>
#include <memory>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "robot/MechanismFile.h"
#include "servo/RobotSimulation.h"
#include "training/Walker.h"
#include "walking/engine/PositionServoAdapter.h"

namespace plumbline::training {

/// The walk of a robot with position servos: config/walking.yaml and what config/robots/<name>/walking.yaml
/// has of its own.
inline walking::WalkGaits readServoGaits(const std::string& robot) {
  const ConfigFile file("walking", {configFolder(), configPath("robots/" + robot)});
  walking::WalkGaits gaits = walking::readWalkGaits(file.root());
  file.checkUnknown();
  return gaits;
}

/// The sensor data of a simulated robot for the walk.
inline walking::ServoMeasurement measurementOf(const servo::RobotSimulation& robot) {
  const servo::ServoReadings& readings = robot.readings();
  walking::ServoMeasurement measured;
  measured.position.resize(readings.position.size());
  for (std::size_t j = 0; j < readings.position.size(); ++j)
    measured.position[j] = robot.encoder(static_cast<int>(j));
  measured.gyro = readings.gyro;
  measured.acc = readings.acc;
  measured.footForce = readings.footForce;
  return measured;
}

/// A robot with position servos that walks with the walk engine, by default in the usual simulation.
class ServoWalker : public Walker {
public:
  explicit ServoWalker(const std::string& robot) : ServoWalker(findMechanism(robot), readServoGaits(robot)) {}
  ServoWalker(const Mechanism& robot, const walking::WalkGaits& gaits)
      : ServoWalker(robot, gaits, servo::RobotSimulations::make(servo::RobotSimulations::usual, robot)) {}
  ServoWalker(const Mechanism& robot, const walking::WalkGaits& gaits,
              std::unique_ptr<servo::RobotSimulation> plant)
      : Walker(Humanoid(robot).model(), gaits, 1 / robot.controlHz),
        robot_(robot),
        mass_(robot.totalMass()),
        driver_(robot),
        plant_(std::move(plant)) {
    restart();
  }

  void push(const Vec3& change) override { plant_->push(mass_ * change / cycle, cycle, 0); }
  Pose3 torso() const override { return translation(offset_.x(), offset_.y(), 0) * plant_->base().pose; }
  Vec2 comVelocity() override {
    return Eigen::Rotation2Dd(-pose().heading) * Vec2(plant_->comVelocity().head<2>());
  }
  servo::RobotSimulation& plant() { return *plant_; }
  /// Called each cycle with the robot's sensor data and commands, before it moves.
  std::function<void(const walking::ServoMeasurement&, const walking::ServoCommand&)> observer;
  /// The last commands.
  const walking::WalkSensors& sensors() const { return sensed_; }

private:
  void put(const Pose2& place, const JointArray& angles) override {
    driver_.reset();
    plant_->restart(driver_.humanoid().toMechanism(angles), place.heading);
    offset_.setZero();
    move(place.position);
  }
  void move(const Vec2& place) override { offset_ = place - plant_->base().pose.translation().head<2>(); }
  walking::WalkSensors sense() override {
    measured_ = measurementOf(*plant_);
    return sensed_ = driver_.sense(measured_);
  }
  void act(const walking::WalkOutput& output, const walking::WalkSensors& sensors) override {
    walking::ServoCommand command = driver_.command(output, engine.gait(), sensors);
    // A simulation whose joints of one motor have a servo each needs the same command for them; others ignore
    // it.
    for (std::size_t j = 0; j < command.target.size(); ++j)
      if (const Mechanism::Joint& joint = robot_.joints[j]; joint.driver >= 0)
        command.target[j] = joint.driven(command.target[static_cast<std::size_t>(joint.driver)]);
    if (observer) observer(measured_, command);
    plant_->command(command.target);
    for (std::size_t j = 0; j < command.stiffness.size(); ++j)
      plant_->setStiffness(static_cast<int>(j), command.stiffness[j]);
    plant_->step();
  }

  const Mechanism robot_;
  double mass_;
  walking::PositionServoAdapter driver_;
  std::unique_ptr<servo::RobotSimulation> plant_;
  walking::ServoMeasurement measured_;
  walking::WalkSensors sensed_;
  Vec2 offset_ = Vec2::Zero();  ///< the ground has no end
};

}  // namespace plumbline::training
