#pragma once
#include <algorithm>
#include <deque>
#include <vector>

#include "RealityEffect.h"
#include "robot/Mechanism.h"

namespace plumbline::reality {

/// One joint's servo, gear and encoder with all that effects do to them: the contract's law, and what it
/// lacks. It knows no physics engine: it gets positions and speeds, and gives torques.
class Drive {
public:
  Drive(const Mechanism& robot, int joint, const std::vector<RealityEffect>& effects, double step);

  /// Play or a soft gear: rotor and link turn apart.
  bool isGeared() const { return play_ > 0 || compliance_ > 0; }
  double rotorInertia() const { return armature_; }
  double viscousFriction() const { return viscous_; }
  double maxTorque() const { return nominal_.maxTorque; }
  bool hasDryFriction() const {
    return coulomb_ > 0 || stribeck_ > 0 || load_ > 0 || loadAtRest_ > 0 || loadSquaredAtRest_ > 0;
  }

  /// The supply sags under its load: the share of their largest torques that all motors together give [0..1].
  void supplyLoad(double share) { supply_ = std::max(0.1, 1 - sag_ * share); }

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
  /// that went through the gear in the last step. `rubbed`: what dry friction did to the rotor then.
  /// `neighbour`: speed of another joint's command, for crosstalk.
  Torques update(double t, double qRotor, double vRotor, double qLink, double vLink, double transmitted,
                 double rubbed, double neighbour);

  /// What the encoder shows, noise aside.
  double encoder(double qRotor, double qLink) const;

private:
  double setPoint(double t, double neighbour);
  double servoTorque(double t, double set, double q, double v);
  static double fadedLimit(double limit, double maxSpeed, double v, double torque);

  const Mechanism::Joint& nominal_;
  double step_;
  Servo servo_;
  double maxTorque_, maxSpeed_;
  bool limitMotor_ = false;  ///< a DC motor has a torque limit of its own
  double motorLimitFactor_ = 1;
  double extraDamping_ = 0;  ///< change of kd beside the back EMF
  bool encoderAtLink_;
  double armature_ = 0, viscous_ = 0, coulomb_ = 0, stribeck_ = 0, stribeckSpeed_ = 0.1, load_ = 0;
  double loadAtRest_ = 0, loadSquaredAtRest_ = 0;  ///< of the load and of its square [1, 1/(N m)]
  double oneWay_ = 0;                              ///< against positive motion, whichever way it turns [N m]
  double profileFastest_ = 0;                      ///< of the servo's own goal [rad/s]; 0: no limit
  double fullDuty_ = 0;                            ///< torque of full duty, standing still [N m]; 0: no limit
  double sag_ = 0, supply_ = 1;                    ///< at full load; share of the voltage that is left
  double play_ = 0, compliance_ = 0, gearStiffness_ = 0, gearDamping_ = 0, delay_ = 0, acceleration_ = 0,
         deadBand_ = 0;
  bool bandIsWhole_ = false, heatIsWork_ = false;
  double bias_ = 0, derating_ = 0, heat_ = 0, offset_ = 0, wobble_ = 0, wobblePhase_ = 0;
  double ripple_ = 0, ripplePeriods_ = 24, ripplePhase_ = 0.7;
  double spring_ = 0, cable_ = 0, dampingOneWay_ = 0, drift_ = 0, driftTime_ = 15, integral_ = 0, lag_ = 0,
         resolution_ = 0, crosstalk_ = 0;
  double bristle_ = 0;

  std::deque<std::pair<double, double>> pending_;
  double current_ = 0, profile_ = 0, profileSpeed_ = 0, lagged_ = 0, summed_ = 0, rest_ = 0, bristleAt_ = 0,
         begun_ = -1;
};

}  // namespace plumbline::reality
