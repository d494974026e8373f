#pragma once
#include <algorithm>
#include <functional>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline {

/// A torque on a joint's link, positive as the joint turns [N m], of its angle [rad] and its speed [rad/s].
/// It must be smooth: a simulation takes it as it is when a step begins.
using JointTorque = std::function<double(double angle, double speed)>;

/// A joint with its drive for a simulation: its servo, and properties of drives that the nominal servo law
/// does not have. Without an effect they have their nominal values.
struct JointPlant {
  /// The part of maxSpeed over which the torque fades to nothing.
  static constexpr double fadeShare = 0.1;

  Servo servo;
  double maxTorque = 0, maxSpeed = 0;  ///< [N m, rad/s]
  double torqueFactor = 1;             ///< on maxTorque; a DC motor has a limit only where this is below 1
  /// Of a servo that falls short by its duty: torque standing still at the most that it may have [N m]. Its
  /// back EMF comes off that, and no other limit counts. 0: a position servo falls short by its torque.
  double fullDutyTorque = 0;
  double supplyFactor = 1;       ///< on a DC motor's supply
  bool linkEncoder = false;      ///< position measured behind the gear
  double commandDelay = 0;       ///< [s]
  double commandLag = 0;         ///< time constant of a first-order filter of commands [s]
  double accelerationLimit = 0;  ///< of the servo's own profile [rad/s^2]; 0: none
  double profileSpeed = 0;       ///< largest of that profile [rad/s]; 0: none
  /// Share of the supply lost while all motors of the robot together give their largest torque (SupplyRail).
  double supplySag = 0;
  double deadBand = 0;              ///< [rad]
  bool deadBandSteps = false;       ///< beyond the band the whole error counts, not what exceeds it
  double extraDamping = 0;          ///< change of kd, which a DC motor adds to its back EMF [N m s/rad]
  double coulomb = 0, viscous = 0;  ///< [N m, N m s/rad]
  double stribeck = 0;              ///< extra at rest [N m]
  double stribeckSpeed = 0.1;       ///< at which it has fallen to 1/e [rad/s]
  double loadFriction = 0;          ///< share of the torque transmitted
  /// The load of the gear: the motor's torque minus the part that accelerates its rotor, the torque that
  /// reaches the link after friction, or the motor's torque.
  enum class Load { gearTorque, linkTorque, motorTorque };
  Load loadIs = Load::gearTorque;
  double linkLoadFriction = 0;       ///< share of the torque that reaches the link, added to loadFriction's
  double loadStribeck = 0;           ///< share of the torque transmitted, extra at rest
  double loadStribeckSpeed = 0.1;    ///< at which what load adds at rest has fallen to 1/e [rad/s]
  double quadraticLoadFriction = 0;  ///< at rest, of the square of the torque that goes through [1/(N m)]
  /// Which way the torque goes through the gear where friction grows with its square.
  enum class Flow { either, motorDrives, loadDrives };
  Flow quadraticFlow = Flow::either;
  double coulombForward = 0, coulombBackward = 0;  ///< added to coulomb, against one way of turning [N m]
  double backlash = 0;                             ///< whole play [rad]
  double toothStiffness = 4000;  ///< of the flanks of a gear with play, far stiffer than any servo [N m/rad]
  double toothDamping = 0.6;     ///< of them, in parts of twice the critical one of the rotor
  double compliance = 0;         ///< of the gear [rad/(N m)]
  double biasForce = 0;          ///< [N m]
  double deratingPerJoule = 0;   ///< share of maxTorque lost per joule
  bool heatIsWork = false;       ///< joules of |torque * speed|, else of torque squared
  double offset = 0;             ///< link angle minus measured angle [rad]
  double encoderAmplitude = 0, encoderPhase = 0;  ///< measured = true + amplitude sin(true + phase)
  std::vector<JointTorque> torques;               ///< whatever else acts on the link

  /// The drive of a joint with nothing unmodelled.
  static JointPlant nominal(const Mechanism::Joint& joint) {
    JointPlant drive;
    drive.servo = joint.servo;
    drive.maxTorque = joint.maxTorque;
    drive.maxSpeed = joint.maxSpeed;
    drive.coulomb = joint.friction;
    drive.viscous = joint.damping;
    drive.linkEncoder = joint.encoder == Mechanism::Joint::Encoder::link;
    return drive;
  }
  /// Largest duty of a DC motor.
  double mostDuty() const {
    if (fullDutyTorque <= 0) return servo.maxPwm;
    return std::min(servo.maxPwm, fullDutyTorque * servo.R / (servo.kt * servo.vin));
  }
  /// It has dry friction of some kind.
  bool hasFriction() const {
    return coulomb > 0 || stribeck > 0 || loadFriction > 0 || linkLoadFriction > 0 || loadStribeck > 0 ||
           quadraticLoadFriction > 0 || coulombForward > 0 || coulombBackward > 0;
  }
  /// Motor and link turn apart.
  bool geared() const { return backlash > 0 || compliance > 0; }
};

}  // namespace plumbline
