#pragma once
#include <cmath>

#include "gap/replay/Plant.h"

namespace plumbline::gap {

/// A servo's torque near a state: tau = torque - stiffness x - damping w, for its position x and speed w.
/// regime says which branch of the law applies, so that a solver notices a change.
struct ServoLine {
  double torque = 0;     ///< [N m]
  double stiffness = 0;  ///< [N m/rad]
  double damping = 0;    ///< [N m s/rad]
  int regime = 0;

  double at(double x, double w) const { return torque - stiffness * x - damping * w; }
};

/// The inputs of a servo's law except its command, and what follows from them in any state.
struct ServoTerms {
  /// share: stiffness 0..1. volts: measured supply, 0: as in the table. limitShare: share of the torque limit
  /// that heat leaves. supplyShare: share of the supply that the load leaves, if the supply is not measured.
  struct Given {
    double share = 0, volts = 0, limitShare = 1, supplyShare = 1;
    bool operator==(const Given&) const = default;
  };
  ServoTerms() = default;
  ServoTerms(const JointPlant& plant, const Given& from);

  Given given;
  const JointPlant* plant = nullptr;  ///< null: a servo that is off
  double stiffness = 0;               ///< outside the dead band [N m/rad]
  double damping = 0;                 ///< [N m s/rad]
  double gain = 0;                    ///< duty of a DC motor per error [1/rad]
  double push = 0;                    ///< its torque at full duty [N m]; of other servos, duty is in N m
  double maxDuty = 0;
  double backEmf = 0;      ///< that its supply has to overcome where it follows torques [N m s/rad]
  bool takesSent = false;  ///< speed and torque as well as the command
  bool limits = false;
  double limit = 0, maxSpeed = 0;  ///< [N m, rad/s]; maxSpeed 0: none
};

/// The encoder's reading for a true angle.
inline double measuredAngle(const JointPlant& plant, double angle) {
  const double shown = angle - plant.offset;
  if (plant.encoderAmplitude == 0) return shown;
  return shown + plant.encoderAmplitude * std::sin(shown + plant.encoderPhase);
}

/// What a dead band leaves of an error: nothing within it; beyond it all, or what exceeds it.
struct Banded {
  int regime = 0;       ///< 10 within the band
  double takenOff = 0;  ///< of the error
};
Banded banded(const JointPlant& plant, double error);

/// Holds a torque within a limit [N m] that fades with the speed [rad/s] in the torque's direction.
void holdWithin(double limit, double maxSpeed, double x, double w, ServoLine& line);

/// Holds the torque of a motor that follows torques within what its supply gives at a speed [rad/s].
void holdWithinSupply(const ServoTerms& terms, double x, double w, ServoLine& line);

/// The servo laws (position and dc_motor) of doc/reference/robot-files.md with the changes by effects.
/// command [rad]. x: true angle on the encoder's side, w: its speed. speed, torque: sent with the command, or
/// instead of it; a DC motor that is sent positions ignores them [rad/s, N m]. line: becomes the answer. It
/// is written where it stays, because a copy would wait for it.
inline void putServoLine(const ServoTerms& terms, double command, double x, double w, double speed,
                         double torque, ServoLine& line) {
  line.torque = line.stiffness = line.damping = 0;
  line.regime = 0;
  if (!terms.plant) return;
  const JointPlant& plant = *terms.plant;
  // The encoder's error changes slowly enough to be taken at the state given.
  double target = command + (x - measuredAngle(plant, x));
  Banded band;
  if (plant.deadBand > 0) band = banded(plant, target - x);
  line.damping = terms.damping;
  if (band.regime != 10) {
    target -= band.takenOff;
    const double duty = terms.gain * (target - x);
    if (std::abs(duty) > terms.maxDuty) {
      line.torque = terms.push * std::copysign(terms.maxDuty, duty);
      line.regime = duty > 0 ? 6 : 7;
    } else {
      line.stiffness = terms.stiffness;
      line.torque = terms.stiffness * target;
    }
  }
  if (terms.takesSent && (speed != 0 || torque != 0))
    line.torque += line.damping * speed + terms.given.share * torque;
  if (terms.backEmf > 0) holdWithinSupply(terms, x, w, line);
  if (terms.limits) holdWithin(terms.limit, terms.maxSpeed, x, w, line);
  line.regime += band.regime;
}

/// The same as an answer.
inline ServoLine servoLine(const ServoTerms& terms, double command, double x, double w, double speed = 0,
                           double torque = 0) {
  ServoLine line;
  putServoLine(terms, command, x, w, speed, torque, line);
  return line;
}

/// The same for terms that are not needed again, see ServoTerms::Given.
ServoLine servoLine(const JointPlant& plant, double command, double share, double volts, double x, double w,
                    double limitShare, double supplyShare = 1, double speed = 0, double torque = 0);

/// Share of the supply that a motor with this current [A] and speed [rad/s] has on it; NaN where the robot's
/// file does not give its constants. volts: measured supply, 0: as in the table.
double dutyThatDraws(const JointPlant& plant, double current, double speed, double volts);

/// Duty of a DC motor's servo, -1..1, for a command and the encoder's angle [rad]; NaN for other servos.
double dutyOf(const JointPlant& plant, double command, double shown);

}  // namespace plumbline::gap
