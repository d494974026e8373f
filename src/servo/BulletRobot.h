#pragma once
#include <memory>
#include <vector>

#include "robot/Mechanism.h"
#include "robot/SupplyRail.h"
#include "servo/BulletMultiBody.h"
#include "servo/RobotSimulation.h"
#include "servo/ServoDrive.h"
#include "simulation/physics/tree/BoundedSystem.h"

namespace plumbline::servo {

/// The engine "bullet" for robots with position servos: Bullet's multi-body dynamics under the servo law of
/// its Mechanism (stiffness, torque limit, fading near the top speed, rotor's inertia, DC motors, joints
/// driven by another's motor). The servo law, stops, contacts and Coulomb friction are rows of one system per
/// step, solved exactly with the forces at the end of the step, so stiff gains do not oscillate. Soles are
/// boxes; every other link touches the ground with a ball of 3 cm about its centre of mass. The same calls
/// give the same bytes.
class BulletRobot : public RobotSimulation {
public:
  /// Errors: std::invalid_argument for a step or a rate that is not above zero.
  explicit BulletRobot(const Mechanism& mechanism, const RobotSimulationOptions& config = {});

  using RobotSimulation::setStiffness;

  void restart(const Pose3& T_world_base, const std::vector<double>& q) override;
  void restart(const std::vector<double>& q, double heading = 0) override;
  void command(const std::vector<double>& targets) override;
  void setStiffness(int joint, double stiffness) override;
  void push(const Vec3& force, double seconds, int link = 0) override;
  void load(int joint, double torque) override { loads_.at(static_cast<std::size_t>(joint)) = torque; }
  void step() override;
  const ServoReadings& readings() const override { return readings_; }
  double encoder(int joint) const override;
  double encoderSpeed(int joint) const override;
  const simulation::BodyState& link(int index) const final { return body_->link(index); }
  const Mechanism& mechanism() const override { return mechanism_; }

private:
  /// A point of the robot that can touch the ground; its forces are those of the last step [N].
  struct Point {
    int link = 0, foot = -1;
    Vec3 local = Vec3::Zero();
    double radius = 0;
    Vec3 world = Vec3::Zero(), force = Vec3::Zero();
  };
  struct Row {
    enum class Kind { servo, drive, gear, stop, dry, viscous, push, friction } kind;
    int index = 0;  ///< joint or point
    double wanted = 0, compliance = 0, lower = 0, upper = 0;
  };

  void substep();
  void addServoRow(int joint);
  void addStopRow(int joint);
  void addContactRows(int point);
  void addRow(const Row& row, int local);
  void solve();
  bool limitServos();
  bool limitFriction();
  void takeForces();
  void setLaw(std::size_t row);
  void addGearRow(int joint);
  void addFrictionRows(int joint);
  ServoDrive::Side sideOf(int coordinate) const;
  ServoDrive::Side motorSide(int joint) const;
  ServoDrive::Side linkSide(int joint) const;
  int motor(int joint) const { return motors_[static_cast<std::size_t>(joint)]; }
  void sense();
  void senseImu();
  std::vector<double> footForces(int foot) const;

  Mechanism mechanism_;
  Mechanism geared_;         ///< the same with a rotor more for every gear that gives way
  std::vector<int> motors_;  ///< per joint of mechanism_ the joint of `geared` that its motor turns
  RobotSimulationOptions config_;
  int stepsPerCycle_;
  double h_;  ///< of a step [s]
  std::unique_ptr<BulletMultiBody> body_;
  std::vector<ServoDrive> drives_;
  SupplyRail supply_;
  std::vector<double> loads_, frictions_;  ///< extra torques on links; of dry friction, last step [N m]
  std::vector<Point> points_;
  std::vector<Row> rows_;
  simulation::BoundedSystem system_;
  Eigen::VectorXd impulses_;
  ServoReadings readings_;
  std::vector<double> torqueSum_;
  Vec3 imuVelocity_ = Vec3::Zero();
  Vec3 pushForce_ = Vec3::Zero();
  int pushLink_ = 0;
  long pushSteps_ = 0, cycles_ = 0;
};

}  // namespace plumbline::servo
