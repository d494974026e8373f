#pragma once
#include <memory>
#include <vector>

#include "simulation/servo/ServoWorld.h"
#include "walking/ServoDriver.h"

namespace plumbline::walking {

/// A robot with position servos on flat ground, in whatever physics: what ServoWalker needs of it. Joints are
/// the Mechanism's.
class ServoPlant {
public:
  virtual ~ServoPlant() = default;

  /// Upright at the origin with this heading, the lowest sole on the ground, at rest.
  virtual void restart(const std::vector<double>& posture, double heading) = 0;
  /// Of the start of this cycle.
  virtual const ServoMeasurement& measure() = 0;
  virtual void command(const ServoCommand& command) = 0;
  /// A force on the torso's centre of mass during the coming cycle [N, world].
  virtual void push(const Vec3& force) = 0;
  /// Lets one control cycle pass.
  virtual void step() = 0;
  virtual Pose3 torso() const = 0;
  /// True velocity of the robot's centre of mass [m/s, world].
  virtual Vec3 comVelocity() const = 0;
};

/// The project's own world of servo robots (Bullet's dynamics).
class BulletPlant : public ServoPlant {
public:
  explicit BulletPlant(const Mechanism& robot, const simulation::ServoWorldConfig& config = {})
      : world(robot, config) {}

  void restart(const std::vector<double>& posture, double heading) override {
    world.restart(posture, heading);
  }
  const ServoMeasurement& measure() override {
    const simulation::ServoReadings& r = world.readings();
    measured.position.resize(r.position.size());
    for (std::size_t j = 0; j < r.position.size(); ++j)
      measured.position[j] = world.encoder(static_cast<int>(j));
    measured.gyro = r.gyro;
    measured.acc = r.acc;
    measured.footForce = r.footForce;
    return measured;
  }
  void command(const ServoCommand& command) override {
    world.command(command.target);
    for (std::size_t j = 0; j < command.stiffness.size(); ++j)
      world.setStiffness(static_cast<int>(j), command.stiffness[j]);
  }
  void push(const Vec3& force) override { world.push(force, 1 / world.mechanism().controlHz); }
  void step() override { world.step(); }
  Pose3 torso() const override { return world.base().pose; }
  Vec3 comVelocity() const override {
    Vec3 momentum = Vec3::Zero();
    double mass = 0;
    const std::vector<Mechanism::Link>& links = world.mechanism().links;
    for (std::size_t i = 0; i < links.size(); ++i) {
      const simulation::BodyState& link = world.link(static_cast<int>(i));
      momentum += links[i].mass *
                  (link.linearVelocity + link.angularVelocity.cross(link.pose.linear() * links[i].com));
      mass += links[i].mass;
    }
    return momentum / mass;
  }

  simulation::ServoWorld world;

private:
  ServoMeasurement measured;
};

}  // namespace plumbline::walking
