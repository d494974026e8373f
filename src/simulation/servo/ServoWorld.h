#pragma once
#include <memory>
#include <vector>

#include "robot/Mechanism.h"
#include "simulation/BodyState.h"
#include "simulation/physics/tree/BoundedSystem.h"
#include "simulation/servo/ServoBody.h"
#include "simulation/servo/ServoDrive.h"

namespace plumbline::simulation {

struct ServoWorldConfig {
  bool fixedBase = false;      ///< hung up or on a bench: the base stays where it is put
  double stepSeconds = 0.002;  ///< of the physics at most; a control cycle has equal steps [s]
  double groundFriction = 0.8;
  double groundStiffness = 5e5;  ///< per point of contact [N/m]
  double groundDamping = 500;    ///< per point of contact [N s/m]
  /// What the drives of all joints have that the robot's file lacks; empty: nothing. Delays are the caller's.
  std::vector<JointPlant> drives = {};
};

/// What a robot with position servos measures at the start of a control cycle, without noise.
struct ServoReadings {
  double time = 0;                               ///< since the restart [s]
  std::vector<double> position, velocity;        ///< per joint [rad, rad/s]
  std::vector<double> torque;                    ///< of the servo, mean over the last cycle [N m]
  Vec3 gyro = Vec3::Zero(), acc = Vec3::Zero();  ///< in the sensor's axes [rad/s, m/s^2]; acc: specific
                                                 ///< force, mean over the last cycle, (0,0,9.81) at rest
  std::vector<std::vector<double>> footForce;    ///< per foot and sensor, as in the Mechanism [N]
};

/// Any robot with position servos, alone on flat ground or held at its base: Bullet's multi-body dynamics
/// under the servo law of its Mechanism (stiffness, torque limit, fading near the top speed, rotor's inertia,
/// DC motors, joints driven by another's motor). The servo law, stops, contacts and Coulomb friction are rows
/// of one system per step, solved exactly with the forces at the end of the step, so stiff gains stay calm.
/// Soles are boxes; every other link touches the ground with a ball of 3 cm about its centre of mass. The
/// same calls give the same bytes.
class ServoWorld {
public:
  /// Errors: std::invalid_argument for a step or a rate that is not above zero.
  explicit ServoWorld(const Mechanism& mechanism, const ServoWorldConfig& config = {});

  /// Starts anew: this pose of the base, joints at q and commanded there, stiffness 1, at rest.
  void restart(const Pose3& T_world_base, const std::vector<double>& q);
  /// The same with the base upright and the lowest sole (a free robot's lowest point) on the ground.
  void restart(const std::vector<double>& q, double heading = 0);

  /// Targets of all joints from this cycle on [rad]; a driven joint's is ignored.
  void command(const std::vector<double>& targets);
  /// Of all joints or of one, 0..1.
  void setStiffness(double stiffness);
  void setStiffness(int joint, double stiffness);
  /// A force on a link's centre of mass, world [N], for so many seconds from now; one at a time.
  void push(const Vec3& force, double seconds, int link = 0);
  /// An extra torque on a joint's link from now on [N m].
  void load(int joint, double torque) { loads.at(static_cast<std::size_t>(joint)) = torque; }
  /// Lets one control cycle pass.
  void step();

  /// Positions and speeds are the links'.
  const ServoReadings& readings() const { return readings_; }
  /// What the joint's encoder shows, with what its drive does to it, and the speed on that side of its gear.
  double encoder(int joint) const;
  double encoderSpeed(int joint) const;
  /// Of a link's frame [m, m/s], world.
  const BodyState& link(int index) const { return body->link(index); }
  const BodyState& base() const { return body->link(0); }
  double time() const { return readings_.time; }
  const Mechanism& mechanism() const { return mechanism_; }

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
  int motor(int joint) const { return motors[static_cast<std::size_t>(joint)]; }
  void sense();
  void senseImu();
  std::vector<double> footForces(int foot) const;

  Mechanism mechanism_;
  Mechanism geared;         ///< the same with a rotor more for every gear that gives way
  std::vector<int> motors;  ///< per joint of mechanism_ the joint of `geared` that its motor turns
  ServoWorldConfig config;
  int stepsPerCycle;
  double h;  ///< of a step [s]
  std::unique_ptr<ServoBody> body;
  std::vector<ServoDrive> drives;
  std::vector<double> loads, frictions;  ///< extra torques on links; of dry friction, last step [N m]
  std::vector<Point> points;
  std::vector<Row> rows;
  BoundedSystem system;
  Eigen::VectorXd impulses;
  ServoReadings readings_;
  std::vector<double> torqueSum;
  Vec3 imuVelocity = Vec3::Zero();
  Vec3 pushForce = Vec3::Zero();
  int pushLink = 0;
  long pushSteps = 0, cycles = 0;
};

}  // namespace plumbline::simulation
