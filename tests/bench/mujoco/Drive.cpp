#include "Drive.h"

#include <algorithm>
#include <cmath>

namespace plumbline::reality {
namespace {

// A gear whose teeth touch: stiff against everything else, soft enough for the step.
constexpr double toothStiffness = 3000;  // N m/rad
constexpr double restSpeed = 0.1;        // at which what load adds at rest has fallen to 1/e [rad/s]

double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

}  // namespace

Drive::Drive(const Mechanism& robot, int joint, const std::vector<RealityEffect>& effects, double step)
    : nominal_(robot.joints[static_cast<std::size_t>(joint)]),
      step_(step),
      servo_(nominal_.servo),
      maxTorque_(nominal_.maxTorque),
      maxSpeed_(nominal_.maxSpeed),
      encoderAtLink_(nominal_.encoder == Mechanism::Joint::Encoder::link) {
  armature_ = servo_.armature;
  for (const RealityEffect& e : effects) {
    const std::vector<int> joints = jointsOf(e, robot);
    if (std::find(joints.begin(), joints.end(), joint) == joints.end()) continue;
    const double x = e.value;
    const std::string& id = e.effect;
    if (id == "command_delay") delay_ += x;
    if (id == "servo_gain") servo_.kp *= x, servo_.errorGain *= x;
    if (id == "servo_damping") extraDamping_ += (x - 1) * servo_.kd, servo_.kd *= x;
    if (id == "torque_limit") maxTorque_ *= x, motorLimitFactor_ *= x, limitMotor_ = true;
    if (id == "speed_limit") maxSpeed_ *= x;
    if (id == "supply_voltage") maxTorque_ *= x, maxSpeed_ *= x, servo_.vin *= x;
    if (id == "coulomb_friction") coulomb_ += x;
    if (id == "viscous_friction") viscous_ += x;
    if (id == "stribeck_friction") stribeck_ += x, stribeckSpeed_ = e.number("speed", 0.1);
    if (id == "load_friction") load_ += x;
    if (id == "load_stribeck_friction") loadAtRest_ += x;
    if (id == "quadratic_load_friction") loadSquaredAtRest_ += x;
    // Friction one way alone: half of it both ways, and half of it as a torque against that way.
    if (id == "asymmetric_friction") coulomb_ += std::abs(x) / 2, oneWay_ += x / 2;
    if (id == "profile_speed") profileFastest_ = x;
    if (id == "duty_limit") fullDuty_ = x;
    if (id == "supply_sag") sag_ += x;
    if (id == "backlash") play_ += x;
    if (id == "joint_compliance") compliance_ += x;
    if (id == "backlash" || id == "joint_compliance") {
      if (e.how.count("side")) encoderAtLink_ = e.how.at("side") == "link";
    }
    if (id == "acceleration_limit") acceleration_ = x;
    if (id == "dead_band") deadBand_ += x, bandIsWhole_ = e.choice("band", "excess") == "whole";
    if (id == "bias_force") bias_ += x;
    if (id == "thermal_derating") derating_ += x, heatIsWork_ = e.choice("heat", "torque") == "work";
    if (id == "rotor_inertia") armature_ += x;
    if (id == "joint_offset") offset_ += x;
    if (id == "encoder_nonlinearity") wobble_ += x, wobblePhase_ = e.number("phase", 0);
    if (id == "gear_ripple") ripple_ = x, ripplePeriods_ = e.number("periods", 24);
    if (id == "cogging") ripple_ = x, ripplePeriods_ = e.number("periods", 72);
    if (id == "joint_spring") spring_ += x;
    if (id == "cable_spring") cable_ += x;
    if (id == "asymmetric_damping") dampingOneWay_ += x;
    if (id == "gain_drift") drift_ += x, driftTime_ = e.number("time", 15);
    if (id == "servo_integral") integral_ += x;
    if (id == "command_lag") lag_ += x;
    if (id == "command_resolution") resolution_ += x;
    if (id == "crosstalk") crosstalk_ += x;
    if (id == "bristle_friction") bristle_ += x;
  }
}

void Drive::start(double q) { current_ = profile_ = lagged_ = rest_ = bristleAt_ = q; }

void Drive::carries(double inertia) {
  const double least = std::min(inertia, armature_);
  gearStiffness_ =
      compliance_ > 0 ? 1 / compliance_ : std::min(toothStiffness, 0.2 * least / (step_ * step_));
  gearDamping_ =
      std::min((compliance_ > 0 ? 0.1 : 1.2) * std::sqrt(gearStiffness_ * armature_), 0.3 * least / step_);
}

void Drive::command(double t, double value) { pending_.emplace_back(t + delay_, value); }

double Drive::encoder(double qRotor, double qLink) const {
  const double q = (encoderAtLink_ ? qLink : qRotor) - offset_;
  return wobble_ == 0 ? q : q + wobble_ * std::sin(q + wobblePhase_);
}

double Drive::setPoint(double t, double neighbour) {
  while (!pending_.empty() && pending_.front().first <= t + 1e-9) {
    current_ = pending_.front().second;
    pending_.pop_front();
  }
  double set = current_ + crosstalk_ * neighbour;
  if (resolution_ > 0) set = std::round(set / resolution_) * resolution_;
  if (lag_ > 0) set = lagged_ += (set - lagged_) * (1 - std::exp(-step_ / lag_));
  if (acceleration_ == 0 && profileFastest_ > 0) {
    const double most = profileFastest_ * step_;
    set = profile_ += std::clamp(set - profile_, -most, most);
  } else if (acceleration_ > 0) {
    // A trapezoid: as fast as can still be braked, and as the motor may turn.
    const double way = set - profile_;
    const double fastest =
        profileFastest_ > 0 ? std::min(profileFastest_, nominal_.maxSpeed) : nominal_.maxSpeed;
    const double wanted = sign(way) * std::min(fastest, std::sqrt(2 * acceleration_ * std::abs(way)));
    const double most = acceleration_ * step_;
    profileSpeed_ += std::clamp(wanted - profileSpeed_, -most, most);
    if (std::abs(way) < most * step_ && std::abs(profileSpeed_) <= 2 * most)
      profile_ = set, profileSpeed_ = 0;
    else
      profile_ += profileSpeed_ * step_;
    set = profile_;
  }
  return set;
}

double Drive::fadedLimit(double limit, double maxSpeed, double v, double torque) {
  if (torque * v <= 0) return limit;
  return limit * std::clamp((maxSpeed - std::abs(v)) / (0.1 * maxSpeed), 0.0, 1.0);
}

double Drive::servoTorque(double t, double set, double q, double v) {
  double error = set - q;
  if (deadBand_ > 0) {
    if (std::abs(error) <= deadBand_)
      error = 0;
    else if (!bandIsWhole_)
      error -= sign(error) * deadBand_;
  }
  if (integral_ > 0) {
    const double most = maxTorque_ / servo_.kp;  // against winding up
    summed_ = std::clamp(summed_ + integral_ * error * step_, -most, most);
    error += summed_;
  }
  double gain = 1;
  if (drift_ != 0) gain = 1 - drift_ * std::min(1.0, std::max(0.0, t) / driftTime_);
  const double limit = maxTorque_ * supply_ * std::max(0.0, 1 - derating_ * heat_);
  double torque = 0;
  if (servo_.model == Servo::Model::dcMotor) {
    const double duty =
        std::clamp(gain * servo_.kpFirmware * servo_.errorGain * error, -servo_.maxPwm, servo_.maxPwm);
    torque = servo_.kt * (supply_ * servo_.vin * duty - servo_.kt * v) / servo_.R - extraDamping_ * v;
    if (limitMotor_ || derating_ > 0) torque = std::clamp(torque, -limit, limit);
  } else if (fullDuty_ > 0) {
    torque = std::clamp(gain * servo_.kp * error, -fullDuty_ * supply_, fullDuty_ * supply_) - servo_.kd * v;
  } else {
    torque = gain * servo_.kp * error - servo_.kd * v;
    const double most = fadedLimit(limit, supply_ * maxSpeed_, v, torque);
    torque = std::clamp(torque, -most, most);
  }
  heat_ += (heatIsWork_ ? std::abs(torque * v) : torque * torque) * step_;
  return torque;
}

Drive::Torques Drive::update(double t, double qRotor, double vRotor, double qLink, double vLink,
                             double transmitted, double rubbed, double neighbour) {
  Torques result;
  const double vSensed = encoderAtLink_ ? vLink : vRotor;
  result.motor = servoTorque(t, setPoint(t, neighbour), encoder(qRotor, qLink), vSensed);
  if (ripple_ != 0) result.motor += ripple_ * std::sin(ripplePeriods_ * qRotor + ripplePhase_);
  result.motor -= oneWay_;
  if (dampingOneWay_ != 0 && vRotor > 0) result.motor -= dampingOneWay_ * vRotor;
  if (bristle_ > 0) {
    // Dahl's model: the force builds up over a way of 0.02 rad.
    constexpr double way = 0.02;
    const double stiffness = bristle_ / way;
    if (qRotor - bristleAt_ > way) bristleAt_ = qRotor - way;
    if (qRotor - bristleAt_ < -way) bristleAt_ = qRotor + way;
    result.motor -= stiffness * (qRotor - bristleAt_);
  }
  result.link = bias_;
  result.link -= spring_ * (qLink - rest_);
  if (cable_ > 0 && qLink > rest_) result.link -= cable_ * (qLink - rest_);
  if (isGeared()) {
    const double apart = qRotor - qLink, beyond = apart - std::clamp(apart, -play_ / 2, play_ / 2);
    if (beyond != 0) {
      result.gear = gearStiffness_ * beyond + gearDamping_ * (vRotor - vLink);
      if (result.gear * beyond < 0) result.gear = 0;  // teeth push, they do not pull
    }
    if (play_ == 0) result.gear = gearStiffness_ * apart + gearDamping_ * (vRotor - vLink);
  }
  const double s = vRotor / stribeckSpeed_;
  // What reaches the link is what friction leaves; where both pull one way, nothing is pressed together.
  const double r = vRotor / restSpeed, reaches = transmitted + rubbed;
  const double least = result.motor * reaches > 0 ? std::min(std::abs(result.motor), std::abs(reaches)) : 0;
  result.friction =
      coulomb_ + stribeck_ * std::exp(-s * s) + load_ * std::abs(transmitted) +
      (loadAtRest_ * std::abs(transmitted) + loadSquaredAtRest_ * least * least) * std::exp(-r * r);
  begun_ = t;
  return result;
}

}  // namespace plumbline::reality
