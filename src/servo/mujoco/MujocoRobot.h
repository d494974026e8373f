#pragma once
#include <memory>
#include <vector>

#include "robot/SupplyRail.h"
#include "servo/RobotSimulation.h"
#include "servo/ServoDrive.h"
#include "servo/mujoco/MujocoWorld.h"
#include "servo/mujoco/SoftGround.h"

namespace plumbline::servo::mujoco {

/// The engine "mujoco" for robots with position servos: MuJoCo's multi-body dynamics and contacts under the
/// servo law of the Mechanism (ServoDrive), whose damping is solved with the step. Limits and dry friction
/// are those at the start of the step. Soles alone touch the ground; one that gives way more than the default
/// is SoftGround. A joint that another's motor drives has a servo of its own with the same command. Joints
/// have no stops.
class MujocoRobot : public RobotSimulation {
public:
  /// Errors: std::invalid_argument for a step or a rate that is not above zero or another number of drives;
  /// std::runtime_error where the engine refuses the robot.
  MujocoRobot(const Mechanism& mechanism, const RobotSimulationOptions& options);

  using RobotSimulation::setStiffness;
  void restart(const Pose3& T_world_base, const std::vector<double>& q) override;
  void restart(const std::vector<double>& q, double heading) override;
  void command(const std::vector<double>& targets) override;
  void setStiffness(int joint, double stiffness) override;
  void push(const Vec3& force, double seconds, int link) override;
  void load(int joint, double torque) override { loads_.at(static_cast<std::size_t>(joint)) = torque; }
  void step() override;
  const ServoReadings& readings() const override { return sensed_; }
  double encoder(int joint) const override;
  double encoderSpeed(int joint) const override;
  const simulation::BodyState& link(int index) const override {
    return states_.at(static_cast<std::size_t>(index));
  }
  const Mechanism& mechanism() const override { return robot_; }

private:
  void substep();
  void drive(std::size_t joint);
  double gearTorque(std::size_t joint) const;
  double dryFriction(int velocity) const;
  void pressGround();
  void update();
  void sense();
  std::vector<double> footForces(std::size_t foot) const;
  ServoDrive::Side motorSide(std::size_t joint) const;
  ServoDrive::Side linkSide(std::size_t joint) const;

  const Mechanism robot_;
  const RobotSimulationOptions options_;
  int stepsPerCycle_ = 1;
  double h_ = 0;  ///< of a step [s]
  std::vector<ServoDrive> drives_;
  SupplyRail supply_;
  std::vector<double> loads_, stiffGear_;  ///< [N m]; of a gear's flanks as the step bears them [N m/rad]
  std::unique_ptr<World> world_;
  std::unique_ptr<SoftGround> ground_;  ///< null: the engine's own contacts
  std::vector<simulation::BodyState> states_;
  ServoReadings sensed_;
  std::vector<double> torqueSum_;
  Vec3 imuVelocity_ = Vec3::Zero(), pushForce_ = Vec3::Zero();
  int pushLink_ = 0;
  long pushSteps_ = 0, cycles_ = 0;
};

}  // namespace plumbline::servo::mujoco
