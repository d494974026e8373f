#include "gap/replay/ServoLaw.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::gap {

void holdWithin(double limit, double maxSpeed, double x, double w, ServoLine& line) {
  const double torque = line.at(x, w), sign = torque < 0 ? -1 : 1;
  const double speed = sign * w, fadeFrom = (1 - JointPlant::fadeShare) * maxSpeed;
  double allowed = limit;
  if (maxSpeed > 0 && speed > fadeFrom)
    allowed *= std::max(0.0, (maxSpeed - speed) / (JointPlant::fadeShare * maxSpeed));
  if (std::abs(torque) <= allowed) return;
  line = {};
  if (maxSpeed > 0 && speed > fadeFrom && speed < maxSpeed) {
    line.damping = limit / (JointPlant::fadeShare * maxSpeed);
    line.torque = sign * line.damping * maxSpeed;
    line.regime = sign > 0 ? 3 : 4;
  } else {
    line.torque = sign * allowed;
    line.regime = allowed > 0 ? (sign > 0 ? 1 : 2) : 5;
  }
}

void holdWithinSupply(const ServoTerms& terms, double x, double w, ServoLine& line) {
  const double torque = line.at(x, w), sign = torque < 0 ? -1 : 1;
  if (std::abs(torque) <= terms.push * terms.maxDuty - sign * terms.backEmf * w) return;
  line = {};
  line.torque = sign * terms.push * terms.maxDuty;
  line.damping = terms.backEmf;
  line.regime = sign > 0 ? 6 : 7;
}

Banded banded(const JointPlant& plant, double error) {
  if (plant.deadBand <= 0) return {};
  if (std::abs(error) <= plant.deadBand) return {10, error};
  if (plant.deadBandSteps) return {};
  return {error > 0 ? 20 : 30, std::copysign(plant.deadBand, error)};
}

ServoTerms::ServoTerms(const JointPlant& of, const Given& from) : given(from) {
  const auto [share, volts, limitShare, supplyShare] = from;
  if (share <= 0) return;
  plant = &of;
  const Servo& servo = of.servo;
  limit = share * of.maxTorque * of.torqueFactor * limitShare;
  if (servo.model == Servo::Model::position) {
    stiffness = share * servo.kp;
    damping = share * servo.kd;
    takesSent = limits = true;
    limit *= supplyShare;
    maxSpeed = of.maxSpeed * supplyShare;
    if (of.fullDutyTorque > 0) {
      gain = stiffness;
      push = 1;
      maxDuty = share * of.fullDutyTorque * of.torqueFactor * limitShare * supplyShare;
      limits = false;
    }
  } else {
    const double vin = (volts > 0 ? volts : servo.vin * supplyShare) * of.supplyFactor;
    gain = servo.kpFirmware * servo.errorGain;
    push = share * servo.kt / servo.R * vin;
    maxDuty = of.mostDuty();
    stiffness = push * gain;
    damping = share * (servo.kt * servo.kt / servo.R + of.extraDamping);
    limits = of.torqueFactor < 1 || limitShare < 1;
    if (servo.followsTorque) {
      // The loop about the current makes up for what the motor's own voltage does, within the supply.
      takesSent = limits = true;
      gain = stiffness = 0;
      damping = share * of.extraDamping;
      backEmf = share * servo.kt * servo.kt / servo.R;
    }
  }
}

ServoLine servoLine(const JointPlant& plant, double command, double share, double volts, double x, double w,
                    double limitShare, double supplyShare, double speed, double torque) {
  return servoLine(ServoTerms(plant, {share, volts, limitShare, supplyShare}), command, x, w, speed, torque);
}

double dutyThatDraws(const JointPlant& plant, double current, double speed, double volts) {
  const Servo& servo = plant.servo;
  if (!(servo.kt > 0 && servo.R > 0 && servo.vin > 0)) return std::numeric_limits<double>::quiet_NaN();
  return (current * servo.R + servo.kt * speed) / ((volts > 0 ? volts : servo.vin) * plant.supplyFactor);
}

double dutyOf(const JointPlant& plant, double command, double shown) {
  const Servo& servo = plant.servo;
  if (servo.model != Servo::Model::dcMotor || servo.followsTorque)
    return std::numeric_limits<double>::quiet_NaN();
  const double error = command - shown;
  const double duty = servo.kpFirmware * servo.errorGain * (error - banded(plant, error).takenOff);
  return std::clamp(duty, -plant.mostDuty(), plant.mostDuty());
}

}  // namespace plumbline::gap
