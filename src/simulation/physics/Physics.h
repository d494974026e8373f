#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/Gravity.h"
#include "math/Types.h"
#include "robot/RobotModel.h"
#include "simulation/physics/BodyState.h"

namespace plumbline::simulation {

/// How two touching materials push: softness by ERP (share of the depth undone a step) and CFM [s/kg], slip
/// [m/(s N)] along the surface, friction, and a bounce above a speed of impact.
struct ContactSurface {
  double softErp = 0.2;
  double softCfm = 1e-5;
  double slip = 0;
  double bounce = 0;          ///< coefficient of restitution
  double bounceVelocity = 0;  ///< slower impacts do not bounce [m/s]
  /// Friction by push; infinite: no Coulomb limit, and friction holds even where nothing pushes.
  double friction = std::numeric_limits<double>::infinity();
};

/// Settings of a whole physics world.
struct PhysicsConfig {
  double stepSeconds = 0.02;
  Vec3 gravity{0, 0, -earthGravity};
  double constraintErp = 0.2;
  double constraintCfm = 1e-5;
  double surfaceLayer = 0.001;  ///< depth bodies may sink into each other without a push [m]
  bool autoDisable = true;      ///< bodies at rest fall asleep
  /// surfaces[a][b]: the contact of material a with material b; square and symmetric.
  std::vector<std::vector<ContactSurface>> surfaces;
};

/// Index into PhysicsConfig::surfaces.
using Material = int;

/// A rigid body of an assembly; its frame's origin is its centre of mass.
struct BodySpec {
  Pose3 T_root_body = Pose3::Identity();  ///< with all hinges at zero
  double mass = 0;                        ///< [kg]
  Mat3 inertia = Mat3::Zero();            ///< about the centre of mass, body axes [kg m^2]
  std::optional<Shape> shape;             ///< collider, in the body's frame; none: passes through everything
  Material material = 0;
  double linearDrag = 0;   ///< force = -linearDrag v [N s/m]
  double angularDrag = 0;  ///< torque = -angularDrag w [N m s]
};

/// A hinge with a velocity motor and two stops. Positive turns the child by the right-hand rule about the
/// axis.
struct HingeSpec {
  int child = 0, parent = 0;    ///< bodies of the assembly; parent < child
  Vec3 anchor = Vec3::Zero();   ///< in the root body's frame, hinges at zero [m]
  Vec3 axis = Vec3::UnitZ();    ///< unit, as the anchor
  double lower = 0, upper = 0;  ///< stops [rad]
  double maxTorque = 10;        ///< of the motor [N m]
  double cfm = 1e-8;            ///< softness of the motor
  double stopErp = 0.8, stopCfm = 1e-8, stopBounce = 0;
  double fudgeFactor = 1;  ///< share of the motor's torque that may push off a stop
};

/// Bodies joined to a tree by hinges, body 0 the root: a robot, or a single free body. Bodies of one assembly
/// do not collide with each other unless selfCollision (those joined by a hinge never do).
struct Assembly {
  std::vector<BodySpec> bodies;
  std::vector<HingeSpec> hinges;
  bool selfCollision = false;
};

/// An assembly's configuration in the coordinates every engine has.
struct AssemblyState {
  BodyState root;
  std::vector<double> angle, rate;  ///< per hinge [rad, rad/s]
};

/// One point where two bodies touched in the last step.
struct Contact {
  int assemblyA = -1, bodyA = -1;
  int assemblyB = -1, bodyB = -1;  ///< -1: the ground or another static shape
  Vec3 point = Vec3::Zero();       ///< world [m]
  Vec3 forceOnA = Vec3::Zero();    ///< world [N]; zero while all bodies involved sleep
};

/// A physics engine as the simulator needs one: bodies, hinges with motors, contacts, step. Assemblies are
/// named by handles that count up from 0 and are not reused. Same calls, same bytes.
class Physics {
public:
  virtual ~Physics() = default;

  /// The plane z = 0.
  virtual void addGround(Material material) = 0;
  /// A shape that never moves.
  virtual void addStatic(const Shape& shape, const Pose3& T_world_shape, Material material) = 0;
  virtual int addAssembly(const Assembly& assembly, const Pose3& T_world_root) = 0;
  virtual void removeAssembly(int assembly) = 0;

  virtual void setMotor(int assembly, int hinge, double velocity) = 0;  ///< [rad/s], kept until changed
  virtual double hingeAngle(int assembly, int hinge) const = 0;         ///< [rad]
  virtual void step() = 0;
  virtual const std::vector<Contact>& contacts() const = 0;

  virtual BodyState bodyState(int assembly, int body) const = 0;
  virtual AssemblyState state(int assembly) const = 0;
  /// Places every body, wakes the assembly; motors keep their velocity.
  virtual void setState(int assembly, const AssemblyState& state) = 0;
  /// The velocities of a state only; poses stay to the last bit, with the small gaps load has torn into
  /// hinges; wakes nothing.
  virtual void setVelocities(int assembly, const AssemblyState& state) = 0;
  /// Moves all bodies rigidly to the root's new pose and stops them, hinges as they are; wakes nothing.
  virtual void moveRigidly(int assembly, const Pose3& T_world_root) = 0;
  /// Wakes the body; what it is joined to or touches wakes in the next step.
  virtual void wake(int assembly, int body) = 0;
  virtual bool asleep(int assembly) const = 0;
};

/// Names of the engines there are.
const std::vector<std::string>& physicsEngines();

/// Makes an engine by name, as "ode", the league's. Error: std::invalid_argument naming the engines there
/// are.
std::unique_ptr<Physics> makePhysics(std::string_view engine, const PhysicsConfig& config);

}  // namespace plumbline::simulation
