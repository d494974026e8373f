#pragma once
#include "robot/JointPlant.h"

namespace plumbline {

/// Torques at a gear [N m], positive as the joint turns.
struct GearLoad {
  double motor = 0;  ///< of the motor
  double gear = 0;   ///< of the motor minus the part that accelerates its rotor
  double link = 0;   ///< torque that reaches the link after friction

  /// The load as a drive's loadIs defines it.
  double of(JointPlant::Load load) const {
    return load == JointPlant::Load::linkTorque ? link : load == JointPlant::Load::motorTorque ? motor : gear;
  }
};

/// Largest torque of dry friction against positive (forward) and negative motion [N m].
struct DryFriction {
  double forward = 0, backward = 0;
};

/// Dry friction of a drive whose motor turns at that speed [rad/s]. The models are M1 to M6 of Duclusaud,
/// Passault, Padois and Daney, "Extended friction models for the physics simulation of servo actuators"
/// (2024). They are Coulomb, Stribeck, load-dependent, both, separate for motor and load, and with the square
/// of the load. There is also Coulomb friction that differs by direction.
DryFriction dryFriction(const JointPlant& plant, double speed, const GearLoad& load);

}  // namespace plumbline
