#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/JointPlant.h"
#include "robot/Mechanism.h"
#include "simulation/physics/BodyState.h"

namespace plumbline::servo {

struct RobotSimulationOptions {
  bool fixedBase = false;      ///< hung up or on a bench: the base stays where it is put
  double stepSeconds = 0.002;  ///< of the physics at most; a control cycle has equal steps [s]
  double groundFriction = 0.8;
  double groundStiffness = 5e5;  ///< per point of contact [N/m]
  double groundDamping = 500;    ///< per point of contact [N s/m]
  /// Properties of all joints' drives that are not in the robot's file; empty: none. The caller adds delays.
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

/// A robot with position servos, alone on flat ground or with a fixed base, in one of the engines: the
/// interface for walking, recordings and sealed benchmarks. Joints and links are those of the Mechanism, in
/// its order. The same calls give the same bytes.
class RobotSimulation {
public:
  virtual ~RobotSimulation() = default;
  RobotSimulation(const RobotSimulation&) = delete;
  RobotSimulation& operator=(const RobotSimulation&) = delete;
  RobotSimulation(RobotSimulation&&) = default;
  RobotSimulation& operator=(RobotSimulation&&) = default;

  /// Restarts: this pose of the base, joints at q and commanded there, stiffness 1, at rest. Throws
  /// std::invalid_argument for another number of joints.
  virtual void restart(const Pose3& T_world_base, const std::vector<double>& q) = 0;
  /// The same with the base upright and the lowest sole (a free robot's lowest point) on the ground.
  virtual void restart(const std::vector<double>& q, double heading) = 0;

  /// Targets of all joints from this cycle on [rad]; a driven joint's is ignored. Throws
  /// std::invalid_argument for another number of them and for one that is not finite.
  virtual void command(const std::vector<double>& targets) = 0;
  /// Of one joint or of all, 0..1.
  virtual void setStiffness(int joint, double stiffness) = 0;
  void setStiffness(double stiffness) {
    for (int i = 0; i < mechanism().numJoints(); ++i) setStiffness(i, stiffness);
  }
  /// A force on a link's centre of mass, world [N], for so many seconds from now; one at a time.
  virtual void push(const Vec3& force, double seconds, int link) = 0;
  /// An extra torque on a joint's link from now on [N m].
  virtual void load(int joint, double torque) = 0;
  /// Lets one control cycle pass.
  virtual void step() = 0;

  /// Positions and speeds are the links'.
  virtual const ServoReadings& readings() const = 0;
  /// Reading of the joint's encoder with the drive's effects, and the speed on that side of its gear.
  virtual double encoder(int joint) const = 0;
  virtual double encoderSpeed(int joint) const = 0;
  /// Of a link's frame [m, m/s], world.
  virtual const simulation::BodyState& link(int index) const = 0;
  virtual const Mechanism& mechanism() const = 0;

  /// Number of the joint of that name; throws std::invalid_argument with the nearest name there is.
  int joint(std::string_view name) const { return mechanism().requireJoint(name); }
  const simulation::BodyState& base() const { return link(0); }
  double time() const { return readings().time; }
  /// Velocity of the centre of mass of all links, world [m/s].
  Vec3 comVelocity() const;

protected:
  RobotSimulation() = default;
};

/// The engines registered with MAKE_ROBOT_SIMULATION.
class RobotSimulations {
public:
  using Maker =
      std::function<std::unique_ptr<RobotSimulation>(const Mechanism&, const RobotSimulationOptions&)>;
  /// What simulates where no engine is chosen.
  static constexpr const char* usual = "bullet";
  static bool add(const std::string& engine, Maker maker);
  /// Those of this program, sorted.
  static std::vector<std::string> names();
  /// Throws std::invalid_argument for an engine that this program lacks: what to install, or the nearest
  /// name. `others`: names that mean something else where this one was given.
  static void require(const std::string& engine, const std::vector<std::string>& others = {});
  static std::unique_ptr<RobotSimulation> make(const std::string& engine, const Mechanism& mechanism,
                                               const RobotSimulationOptions& options = {});
};

}  // namespace plumbline::servo

/// In a .cpp: robots with position servos are simulated by this class under the name `engine`.
#define MAKE_ROBOT_SIMULATION(engine, Class)                                                                 \
  [[maybe_unused]] static const bool plumblineSimulation##Class = ::plumbline::servo::RobotSimulations::add( \
      engine,                                                                                                \
      [](const ::plumbline::Mechanism& mechanism, const ::plumbline::servo::RobotSimulationOptions& options) \
          -> std::unique_ptr<::plumbline::servo::RobotSimulation> {                                          \
        return std::make_unique<Class>(mechanism, options);                                                  \
      });
