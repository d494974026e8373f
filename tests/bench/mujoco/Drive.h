#pragma once
#include <deque>
#include <vector>

#include "RealityEffect.h"
#include "robot/Mechanism.h"

namespace plumbline::reality {

/// One joint's servo, gear and encoder with all that effects do to them: the contract's law, and what it
/// lacks. It knows no physics engine: it is told positions and speeds, and tells torques.
class Drive {
public:
  Drive(const Mechanism& robot, int joint, const std::vector<RealityEffect>& effects, double step);

  /// Play or a soft gear: rotor and link turn apart.
  bool isGeared() const { return play > 0 || compliance > 0; }
  double rotorInertia() const { return armature; }
  double viscousFriction() const { return viscous; }

  /// Inertia of what hangs on the gear [kg m^2]: teeth on a light link are taken softer, for the step's sake.
  void carries(double inertia);

  /// A command that is sent at time t; it becomes valid later by the delay.
  void command(double t, double value);
  /// The posture at rest, from which springs pull, and the command of the beginning.
  void start(double q);

  struct Torques {
    double motor = 0;     ///< on the rotor
    double link = 0;      ///< on the link (beside what comes through the gear)
    double gear = 0;      ///< from rotor to link, where geared
    double friction = 0;  ///< largest dry friction at the rotor
  };
  /// `rotor`, `link`: position and speed of either side; equal where not geared. `transmitted`: the torque
  /// that went through the gear in the last step. `neighbour`: speed of another joint's command, for
  /// crosstalk.
  Torques update(double t, double qRotor, double vRotor, double qLink, double vLink, double transmitted,
                 double neighbour);

  /// What the encoder shows, noise aside.
  double encoder(double qRotor, double qLink) const;

private:
  double setPoint(double t, double neighbour);
  double servoTorque(double t, double set, double q, double v);
  static double fadedLimit(double limit, double maxSpeed, double v, double torque);

  const Mechanism::Joint& nominal;
  double step;
  Servo servo;
  double maxTorque, maxSpeed;
  bool limitMotor = false;  ///< a DC motor has a torque limit of its own
  double motorLimitFactor = 1;
  double extraDamping = 0;  ///< change of kd beside the back EMF
  bool encoderAtLink;
  double armature = 0, viscous = 0, coulomb = 0, stribeck = 0, stribeckSpeed = 0.1, load = 0;
  double play = 0, compliance = 0, gearStiffness = 0, gearDamping = 0, delay = 0, acceleration = 0,
         deadBand = 0;
  bool bandIsWhole = false, heatIsWork = false;
  double bias = 0, derating = 0, heat = 0, offset = 0, wobble = 0, wobblePhase = 0;
  double ripple = 0, ripplePeriods = 24, ripplePhase = 0.7;
  double spring = 0, cable = 0, dampingOneWay = 0, drift = 0, driftTime = 15, integral = 0, lag = 0,
         crosstalk = 0;
  double bristle = 0;

  std::deque<std::pair<double, double>> pending;
  double current = 0, profile = 0, profileSpeed = 0, lagged = 0, summed = 0, rest = 0, bristleAt = 0,
         begun = -1;
};

}  // namespace plumbline::reality
