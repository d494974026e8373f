#include "gap/replay/ServoLaw.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::gap {

namespace {

constexpr double fadeShare = 0.1;  // of the speed limit, over which the torque fades to nothing

/// Holds a torque within a limit that fades with the speed in the torque's direction.
ServoLine limited(const ServoLine& line, double x, double w, double limit, double maxSpeed) {
  const double torque = line.at(x, w), sign = torque < 0 ? -1 : 1;
  const double speed = sign * w, fadeFrom = (1 - fadeShare) * maxSpeed;
  double allowed = limit;
  if (maxSpeed > 0 && speed > fadeFrom) allowed *= std::max(0.0, (maxSpeed - speed) / (fadeShare * maxSpeed));
  if (std::abs(torque) <= allowed) return line;
  ServoLine limitedLine;
  if (maxSpeed > 0 && speed > fadeFrom && speed < maxSpeed) {
    limitedLine.damping = limit / (fadeShare * maxSpeed);
    limitedLine.torque = sign * limitedLine.damping * maxSpeed;
    limitedLine.regime = sign > 0 ? 3 : 4;
  } else {
    limitedLine.torque = sign * allowed;
    limitedLine.regime = allowed > 0 ? (sign > 0 ? 1 : 2) : 5;
  }
  return limitedLine;
}

/// What a dead band leaves of an error: nothing within it; beyond it all, or what exceeds it.
struct Banded {
  int regime = 0;       ///< 10 within the band
  double takenOff = 0;  ///< of the error
};

Banded banded(const JointPlant& plant, double error) {
  if (plant.deadBand <= 0) return {};
  if (std::abs(error) <= plant.deadBand) return {10, error};
  if (plant.deadBandSteps) return {};
  return {error > 0 ? 20 : 30, std::copysign(plant.deadBand, error)};
}

}  // namespace

double measuredAngle(const JointPlant& plant, double angle) {
  const double shown = angle - plant.offset;
  if (plant.encoderAmplitude == 0) return shown;
  return shown + plant.encoderAmplitude * std::sin(shown + plant.encoderPhase);
}

ServoLine servoLine(const JointPlant& plant, double command, double share, double volts, double x, double w,
                    double limitShare, double supplyShare, double speed, double torque) {
  ServoLine line;
  if (share <= 0) return line;
  // The encoder's error changes slowly enough to be taken at the state given.
  double target = command + (x - measuredAngle(plant, x));
  const auto [band, takenOff] = banded(plant, target - x);
  if (band != 10) target -= takenOff;
  const Servo& servo = plant.servo;
  if (servo.model == Servo::Model::position) {
    line.stiffness = band == 10 ? 0 : share * servo.kp;
    line.damping = share * servo.kd;
    line.torque = line.stiffness * target;
    if (speed != 0 || torque != 0) line.torque += line.damping * speed + share * torque;
    line = limited(line, x, w, share * plant.maxTorque * plant.torqueFactor * limitShare * supplyShare,
                   plant.maxSpeed * supplyShare);
  } else {
    const double vin = (volts > 0 ? volts : servo.vin * supplyShare) * plant.supplyFactor;
    const double gain = band == 10 ? 0 : servo.kpFirmware * servo.errorGain,
                 push = share * servo.kt / servo.R * vin;
    const double duty = gain * (target - x);
    line.damping = share * (servo.kt * servo.kt / servo.R + plant.extraDamping);
    if (std::abs(duty) > servo.maxPwm) {
      line.torque = push * std::copysign(servo.maxPwm, duty);
      line.regime = duty > 0 ? 6 : 7;
    } else {
      line.stiffness = push * gain;
      line.torque = line.stiffness * target;
    }
    if (plant.torqueFactor < 1 || limitShare < 1) {
      line = limited(line, x, w, share * plant.maxTorque * plant.torqueFactor * limitShare, 0);
    }
  }
  line.regime += band;
  return line;
}

double dutyThatDraws(const JointPlant& plant, double current, double speed, double volts) {
  const Servo& servo = plant.servo;
  if (!(servo.kt > 0 && servo.R > 0 && servo.vin > 0)) return std::numeric_limits<double>::quiet_NaN();
  return (current * servo.R + servo.kt * speed) / ((volts > 0 ? volts : servo.vin) * plant.supplyFactor);
}

double dutyOf(const JointPlant& plant, double command, double shown) {
  const Servo& servo = plant.servo;
  if (servo.model != Servo::Model::dcMotor) return std::numeric_limits<double>::quiet_NaN();
  const double error = command - shown;
  const double duty = servo.kpFirmware * servo.errorGain * (error - banded(plant, error).takenOff);
  return std::clamp(duty, -servo.maxPwm, servo.maxPwm);
}

}  // namespace plumbline::gap
