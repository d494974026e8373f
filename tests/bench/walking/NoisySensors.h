#pragma once
#include <memory>

#include "math/Random.h"
#include "servo/RobotSimulation.h"

namespace plumbline::bench {

/// A simulated robot with sensors as a real one's: an encoder of 4096 counts a turn, noise on angles, IMU and
/// forces, the same after each restart.
class NoisySensors : public servo::RobotSimulation {
public:
  explicit NoisySensors(std::unique_ptr<servo::RobotSimulation> robot);

  using RobotSimulation::setStiffness;
  void restart(const Pose3& T_world_base, const std::vector<double>& q) override;
  void restart(const std::vector<double>& q, double heading) override;
  void command(const std::vector<double>& targets) override { robot_->command(targets); }
  void setStiffness(int joint, double stiffness) override { robot_->setStiffness(joint, stiffness); }
  void push(const Vec3& force, double seconds, int link) override { robot_->push(force, seconds, link); }
  void load(int joint, double torque) override { robot_->load(joint, torque); }
  void step() override;
  const servo::ServoReadings& readings() const override { return noisy_; }
  double encoder(int joint) const override { return angles_.at(static_cast<std::size_t>(joint)); }
  double encoderSpeed(int joint) const override { return robot_->encoderSpeed(joint); }
  const simulation::BodyState& link(int index) const override { return robot_->link(index); }
  const Mechanism& mechanism() const override { return robot_->mechanism(); }

private:
  void sense();

  const std::unique_ptr<servo::RobotSimulation> robot_;
  servo::ServoReadings noisy_;
  std::vector<double> angles_;  ///< what the encoders show [rad]
  Random random_{1};
};

}  // namespace plumbline::bench
