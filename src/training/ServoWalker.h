#pragma once
#include "framework/ConfigFile.h"
#include "robot/MechanismFile.h"
#include "training/ServoPlant.h"
#include "training/Walker.h"

namespace plumbline::walking {

/// The walk of a robot with position servos: config/walking.yaml and what config/robots/<name>/walking.yaml
/// has of its own.
inline WalkGaits readServoGaits(const std::string& robot) {
  const ConfigFile file("walking", {"config", "config/robots/" + robot});
  WalkGaits gaits = readWalkGaits(file.root());
  file.checkUnknown();
  return gaits;
}

/// A robot with position servos that walks with the engine, by default in the project's own physics.
class ServoWalker : public Walker {
public:
  explicit ServoWalker(const std::string& robot) : ServoWalker(findMechanism(robot), readServoGaits(robot)) {}
  ServoWalker(const Mechanism& robot, const WalkGaits& gaits)
      : ServoWalker(robot, gaits, std::make_unique<BulletPlant>(robot)) {}
  ServoWalker(const Mechanism& robot, const WalkGaits& gaits, std::unique_ptr<ServoPlant> plant_)
      : Walker(Humanoid(robot).model(), gaits, 1 / robot.controlHz),
        mass(robot.totalMass()),
        driver(robot),
        plant_(std::move(plant_)) {
    restart();
  }

  void push(const Vec3& change) override { plant_->push(mass * change / cycle); }
  Pose3 torso() const override { return translation(offset.x(), offset.y(), 0) * plant_->torso(); }
  Vec2 comVelocity() override {
    return Eigen::Rotation2Dd(-pose().heading) * Vec2(plant_->comVelocity().head<2>());
  }
  ServoPlant& plant() { return *plant_; }
  /// What the robot was told last.
  const WalkSensors& sensors() const { return sensed; }

private:
  void put(const Pose2& place, const JointArray& angles) override {
    driver.reset();
    plant_->restart(driver.humanoid().toMechanism(angles), place.heading);
    offset.setZero();
    move(place.position);
  }
  void move(const Vec2& place) override { offset = place - plant_->torso().translation().head<2>(); }
  WalkSensors sense() override { return sensed = driver.sense(plant_->measure()); }
  void act(const WalkOutput& output, const WalkSensors& sensors) override {
    plant_->command(driver.command(output, engine.gait(), sensors));
    plant_->step();
  }

  double mass;
  ServoDriver driver;
  std::unique_ptr<ServoPlant> plant_;
  WalkSensors sensed;
  Vec2 offset = Vec2::Zero();  ///< the ground has no end
};

}  // namespace plumbline::walking
