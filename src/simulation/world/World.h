#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "field/FieldSize.h"
#include "math/Pose2.h"
#include "math/Types.h"
#include "robot/RobotModel.h"
#include "simulation/physics/BodyState.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// Force sensor of a foot or toe: force-weighted mean contact point and total force in the link's *body*
/// frame (origin at its centre of mass, axes as the link's) [m, N]; absent when nothing touches.
struct FootForce {
  Vec3 point = Vec3::Zero();
  Vec3 force = Vec3::Zero();
};

/// What a robot senses without noise, after a step; torso frame x forward, y left, z up.
struct RobotReadings {
  JointArray angle{};        ///< hinge angles [rad]
  Vec3 gyro = Vec3::Zero();  ///< [rad/s]
  Vec3 acc =
      Vec3::Zero();  ///< specific force, one cycle late as on the league's server; (0,0,9.81) at rest [m/s^2]
  std::optional<FootForce> leftFoot, rightFoot, leftToe, rightToe;
};

/// Parameters of the league's physics; the defaults are those of its server (rcssserver3d 0.7.3). Each can be
/// set alone, to simulate a server or a model without that property.
struct LeaguePhysicsParameters {
  double drag = 0.01;         ///< of each of a robot's bodies: force -drag v, torque -drag w [N s/m, N m s]
  double contactErp = 0.4;    ///< of a robot on the ground: share of the depth undone a step
  double contactCfm = 1e-4;   ///< the same: give under force [s/kg]
  double contactSlip = 5e-3;  ///< the same: speed along the ground per force [m/(s N)]
  double jointErp = 0.2;      ///< of hinges: share of a gap that is closed in a step
  double jointCfm = 1e-5;     ///< of hinges: give under force [s/kg]; Bullet's hinges never give
  double motorTorque = 10;    ///< of every motor [N m]
};

/// Engine, step and the physics that the league's server has by accident, each with its switch.
/// (Limbs frozen at self-collision are the referee's: Rules::selfCollision.)
struct WorldConfig {
  std::string engine = "ode";  ///< a name makePhysics knows
  double stepSeconds = 0.02;
  bool bouncingJointStops = true;  ///< a joint that runs into its stop comes back as fast
  bool sleepingRobots = true;      ///< auto-disable; woken by a command that is not zero
  bool endlessFriction = true;     ///< friction without Coulomb's limit; off: frictionCoefficient
  bool lastingCommands = true;     ///< a joint's speed is kept until changed; off: it is a cycle's
  /// The answer to message i shows in message i+2; off: in i+1. What drives the world sees to that (Server,
  /// LocalRobot).
  bool actionDelay = true;
  double frictionCoefficient = 1;
  bool selfCollision = false;  ///< off in effect on the league's server
  LeaguePhysicsParameters numbers;
  FieldSize field;
  /// Effects of robots and ground that are not in their models (simulation/effects/); makeWorld throws
  /// ConfigurationError for effects that are impossible here.
  std::vector<EffectSetting> effects;
};

/// Handle of a robot in a world; stays valid until removed.
using RobotHandle = int;

/// Two robots that touched each other in the last step, at a point [m].
struct RobotContact {
  RobotHandle a, b;
  Vec3 point;
};

/// The physics of a soccer field: robots, one ball, ground, goals and walls. One object is one independent,
/// deterministic world: same calls, same bytes. World frame: origin centre of field, x to the right goal, z
/// up.
class World {
public:
  virtual ~World() = default;

  /// Adds a robot with all joints at zero, its torso at T_world_torso, at rest.
  virtual RobotHandle addRobot(const RobotModel& model, const Pose3& T_world_torso) = 0;
  virtual void removeRobot(RobotHandle robot) = 0;
  /// Moves all bodies rigidly so that the torso gets this pose, keeps the posture, zeroes velocities.
  /// A sleeping robot is not woken by it (as on the league's server).
  virtual void moveRobot(RobotHandle robot, const Pose3& T_world_torso) = 0;
  /// Puts the joints to these angles about a fixed torso pose, at rest, motors at zero, awake.
  virtual void setPosture(RobotHandle robot, const JointArray& angles) = 0;
  /// Puts the torso and the joints to this state of motion [rad, rad/s]; motors go on at their speed, awake.
  virtual void setState(RobotHandle robot, const BodyState& torso, const JointArray& angles,
                        const JointArray& rates) = 0;
  /// Sets only velocities, of the torso's state and of the joints; wakes nothing.
  virtual void setVelocities(RobotHandle robot, const BodyState& torso, const JointArray& rates) = 0;
  /// Hinge motor target [rad/s]; clamped to the joint's speed; persists; ignored for a cycle at a stop.
  virtual void setJointVelocity(RobotHandle robot, JointId joint, double velocity) = 0;

  /// One cycle of stepSeconds.
  virtual void step() = 0;
  /// Everything as after construction but the robots removed; byte-identical behaviour afterwards.
  virtual void reset() = 0;

  virtual const RobotReadings& readings(RobotHandle robot) const = 0;
  virtual BodyState linkState(RobotHandle robot, int link) const = 0;  ///< of the link's centre of mass frame
  virtual BodyState torso(RobotHandle robot) const = 0;
  virtual BodyState ball() const = 0;
  virtual void setBall(const Vec3& position, const Vec3& velocity) = 0;  ///< zeroes its spin
  virtual void setBall(const BodyState& state) = 0;
  /// Robots whose bodies touched the ball in the last step.
  virtual const std::vector<RobotHandle>& ballTouchedBy() const = 0;
  /// Every point where two robots touched each other in the last step.
  virtual const std::vector<RobotContact>& robotContacts() const = 0;
};

}  // namespace plumbline::simulation
