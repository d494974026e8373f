#pragma once
#include "robot/DryFriction.h"

namespace plumbline::servo {

/// One joint's servo with its drive, as a linear law torque = offset - slope * v for the speed v at the end
/// of a step, so that the step can be solved with it. It has no dynamics: the caller gives it the positions
/// of motor and link, and the result of the step. Law of the servo: robot/Mechanism.h; of the rest:
/// JointPlant.
class ServoDrive {
public:
  /// detailed: speeds by the trapezoid, for positions that are read half a step of speed earlier (leapfrog),
  /// and limits fade by the speed after the step, which stays calm at any limit. Else implicit Euler, which
  /// stays calm at any gain.
  explicit ServoDrive(const JointPlant& plant, bool detailed);

  /// At rest there, commanded to stay.
  void start(double q);
  void command(double target) { wanted_ = target; }
  void setStiffness(double share) { stiffness_ = share; }

  struct Side {
    double position = 0, speed = 0;  ///< [rad, rad/s]
  };
  /// Begins a step of h [s]: the law below its limits.
  void begin(double h, const Side& motor, const Side& link);
  /// Whether the law does not hold at this speed at the end of the step; it is then the next stricter one.
  bool limitAt(double speedAfter);
  /// Ends the step: what the motor's speed became, and the torque of the dry friction at it [N m].
  void end(double speedAfter, double friction = 0);

  double offset() const { return law0_; }
  double slope() const { return law1_; }
  double torque(double speedAfter) const { return law0_ - law1_ * speedAfter; }
  double speedAtBegin() const { return speedBefore_; }  ///< of the motor
  double rotor() const { return plant_.servo.armature; }
  /// Most that dry friction holds in this step.
  DryFriction dryLimit() const;
  /// Share of the supply that is left in the next steps (SupplyRail).
  void setSupply(double share) { supply_ = share; }
  const JointPlant& drive() const { return plant_; }
  /// The encoder's reading of the joint.
  double measured(const Side& motor, const Side& link) const;

private:
  enum class Regime { linear, fullDuty, limited, faded, spent };

  double shown(double angle) const;
  double filtered(double h);
  void follow(double h);
  double limit(double sign, double speed) const;
  double limitShare() const;
  double fullLimit() const;
  bool limitDutyAt(double speedAfter);
  double topSpeed() const { return plant_.maxSpeed * supply_; }

  JointPlant plant_;
  bool detailed_;
  double wanted_ = 0, stiffness_ = 1, supply_ = 1;
  double behindLag_ = 0;  ///< what the filter of commands gives
  double profile_ = 0, profileSpeed_ = 0;
  double law0_ = 0, law1_ = 0, error_ = 0, sense_ = 1;  ///< of the step
  double speedBefore_ = 0, linkSpeed_ = 0, step_ = 0, heat_ = 0;
  GearLoad load_;
  bool behindGear_ = false;  ///< the encoder and the motor are on two sides of a gear that gives way
  Regime regime_ = Regime::linear;
};

}  // namespace plumbline::servo
