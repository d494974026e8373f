#pragma once
#include "robot/DryFriction.h"

namespace plumbline::simulation {

/// One joint's servo and what its drive adds to it, as a line torque = offset - slope * v for the speed v at
/// the end of a step, so that the step can be solved with it. It knows no dynamics: it is told where motor
/// and link are, and what came out. Law of the servo: robot/Mechanism.h; of the rest: JointPlant.
class ServoDrive {
public:
  /// detailed: speeds by the trapezoid, for positions that are read half a step of speed earlier (leapfrog),
  /// and limits fade by the speed after the step, which stays calm at any limit. Else implicit Euler, which
  /// stays calm at any gain.
  explicit ServoDrive(const JointPlant& plant, bool detailed);

  /// At rest there, commanded to stay.
  void start(double q);
  void command(double target) { wanted = target; }
  void setStiffness(double share) { stiffness = share; }

  struct Side {
    double position = 0, speed = 0;  ///< [rad, rad/s]
  };
  /// Begins a step of h [s]: the law below its limits.
  void begin(double h, const Side& motor, const Side& link);
  /// Whether the law does not hold at this speed at the end of the step; it is then the next stricter one.
  bool limitAt(double speedAfter);
  /// Ends the step: what the motor's speed became, and the torque of the dry friction at it [N m].
  void end(double speedAfter, double friction = 0);

  double offset() const { return law0; }
  double slope() const { return law1; }
  double torque(double speedAfter) const { return law0 - law1 * speedAfter; }
  double speedAtBegin() const { return speedBefore; }  ///< of the motor
  double rotor() const { return plant.servo.armature; }
  /// Most that dry friction holds in this step.
  DryFriction dryLimit() const;
  /// Share of the supply that is left in the next steps (SupplyRail).
  void setSupply(double share) { supply = share; }
  const JointPlant& drive() const { return plant; }
  /// What the encoder shows of the joint.
  double measured(const Side& motor, const Side& link) const;

private:
  enum class Regime { linear, fullDuty, limited, faded, spent };

  double shown(double angle) const;
  void follow(double h);
  double limit(double sign, double speed) const;
  double fullLimit() const;
  double topSpeed() const { return plant.maxSpeed * supply; }

  JointPlant plant;
  bool detailed;
  double wanted = 0, stiffness = 1, supply = 1;
  double profile = 0, profileSpeed = 0;
  double law0 = 0, law1 = 0, error = 0, sense = 1;  ///< of the step
  double speedBefore = 0, step = 0, heat = 0;
  GearLoad load;
  bool behindGear = false;  ///< the encoder and the motor are on two sides of a gear that gives way
  Regime regime = Regime::linear;
};

}  // namespace plumbline::simulation
