#include "Drive.h"

#include <algorithm>
#include <cmath>

namespace plumbline::reality {
namespace {

// A gear whose teeth touch: stiff against everything else, soft enough for the step.
constexpr double toothStiffness = 3000;  // N m/rad

double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

}  // namespace

Drive::Drive(const Mechanism& robot, int joint, const std::vector<RealityEffect>& effects, double step_)
    : nominal(robot.joints[static_cast<std::size_t>(joint)]),
      step(step_),
      servo(nominal.servo),
      maxTorque(nominal.maxTorque),
      maxSpeed(nominal.maxSpeed),
      encoderAtLink(nominal.encoder == Mechanism::Joint::Encoder::link) {
  armature = servo.armature;
  for (const RealityEffect& e : effects) {
    const std::vector<int> joints = jointsOf(e, robot);
    if (std::find(joints.begin(), joints.end(), joint) == joints.end()) continue;
    const double x = e.value;
    const std::string& id = e.effect;
    if (id == "command_delay") delay += x;
    if (id == "servo_gain") servo.kp *= x, servo.errorGain *= x;
    if (id == "servo_damping") extraDamping += (x - 1) * servo.kd, servo.kd *= x;
    if (id == "torque_limit") maxTorque *= x, motorLimitFactor *= x, limitMotor = true;
    if (id == "speed_limit") maxSpeed *= x;
    if (id == "supply_voltage") maxTorque *= x, maxSpeed *= x, servo.vin *= x;
    if (id == "coulomb_friction") coulomb += x;
    if (id == "viscous_friction") viscous += x;
    if (id == "stribeck_friction") stribeck += x, stribeckSpeed = e.number("speed", 0.1);
    if (id == "load_friction") load += x;
    if (id == "backlash") play += x;
    if (id == "joint_compliance") compliance += x;
    if (id == "backlash" || id == "joint_compliance") {
      if (e.how.count("side")) encoderAtLink = e.how.at("side") == "link";
    }
    if (id == "acceleration_limit") acceleration = x;
    if (id == "dead_band") deadBand += x, bandIsWhole = e.choice("band", "excess") == "whole";
    if (id == "bias_force") bias += x;
    if (id == "thermal_derating") derating += x, heatIsWork = e.choice("heat", "torque") == "work";
    if (id == "rotor_inertia") armature += x;
    if (id == "joint_offset") offset += x;
    if (id == "encoder_nonlinearity") wobble += x, wobblePhase = e.number("phase", 0);
    if (id == "gear_ripple") ripple = x, ripplePeriods = e.number("periods", 24);
    if (id == "cogging") ripple = x, ripplePeriods = e.number("periods", 72);
    if (id == "joint_spring") spring += x;
    if (id == "cable_spring") cable += x;
    if (id == "asymmetric_damping") dampingOneWay += x;
    if (id == "gain_drift") drift += x, driftTime = e.number("time", 15);
    if (id == "servo_integral") integral += x;
    if (id == "command_lag") lag += x;
    if (id == "crosstalk") crosstalk += x;
    if (id == "bristle_friction") bristle += x;
  }
}

void Drive::start(double q) { current = profile = lagged = rest = bristleAt = q; }

void Drive::carries(double inertia) {
  const double least = std::min(inertia, armature);
  gearStiffness = compliance > 0 ? 1 / compliance : std::min(toothStiffness, 0.2 * least / (step * step));
  gearDamping =
      std::min((compliance > 0 ? 0.1 : 1.2) * std::sqrt(gearStiffness * armature), 0.3 * least / step);
}

void Drive::command(double t, double value) { pending.emplace_back(t + delay, value); }

double Drive::encoder(double qRotor, double qLink) const {
  const double q = (encoderAtLink ? qLink : qRotor) - offset;
  return wobble == 0 ? q : q + wobble * std::sin(q + wobblePhase);
}

double Drive::setPoint(double t, double neighbour) {
  while (!pending.empty() && pending.front().first <= t + 1e-9) {
    current = pending.front().second;
    pending.pop_front();
  }
  double set = current + crosstalk * neighbour;
  if (lag > 0) set = lagged += (set - lagged) * std::min(1.0, step / lag);
  if (acceleration > 0) {
    // A trapezoid: as fast as can still be braked, and as the motor may turn.
    const double way = set - profile;
    const double wanted = sign(way) * std::min(nominal.maxSpeed, std::sqrt(2 * acceleration * std::abs(way)));
    const double most = acceleration * step;
    profileSpeed += std::clamp(wanted - profileSpeed, -most, most);
    if (std::abs(way) < most * step && std::abs(profileSpeed) <= 2 * most)
      profile = set, profileSpeed = 0;
    else
      profile += profileSpeed * step;
    set = profile;
  }
  return set;
}

double Drive::fadedLimit(double limit, double maxSpeed, double v, double torque) {
  if (torque * v <= 0) return limit;
  return limit * std::clamp((maxSpeed - std::abs(v)) / (0.1 * maxSpeed), 0.0, 1.0);
}

double Drive::servoTorque(double t, double set, double q, double v) {
  double error = set - q;
  if (deadBand > 0) {
    if (std::abs(error) <= deadBand)
      error = 0;
    else if (!bandIsWhole)
      error -= sign(error) * deadBand;
  }
  if (integral > 0) {
    const double most = maxTorque / servo.kp;  // against winding up
    summed = std::clamp(summed + integral * error * step, -most, most);
    error += summed;
  }
  double gain = 1;
  if (drift != 0) gain = 1 - drift * std::min(1.0, std::max(0.0, t) / driftTime);
  const double limit = maxTorque * std::max(0.0, 1 - derating * heat);
  double torque = 0;
  if (servo.model == Servo::Model::dcMotor) {
    const double duty =
        std::clamp(gain * servo.kpFirmware * servo.errorGain * error, -servo.maxPwm, servo.maxPwm);
    torque = servo.kt * (servo.vin * duty - servo.kt * v) / servo.R - extraDamping * v;
    if (limitMotor || derating > 0) torque = std::clamp(torque, -limit, limit);
  } else {
    torque = gain * servo.kp * error - servo.kd * v;
    const double most = fadedLimit(limit, maxSpeed, v, torque);
    torque = std::clamp(torque, -most, most);
  }
  heat += (heatIsWork ? std::abs(torque * v) : torque * torque) * step;
  return torque;
}

Drive::Torques Drive::update(double t, double qRotor, double vRotor, double qLink, double vLink,
                             double transmitted, double neighbour) {
  Torques result;
  const double vSensed = encoderAtLink ? vLink : vRotor;
  result.motor = servoTorque(t, setPoint(t, neighbour), encoder(qRotor, qLink), vSensed);
  if (ripple != 0) result.motor += ripple * std::sin(ripplePeriods * qRotor + ripplePhase);
  if (dampingOneWay != 0 && vRotor > 0) result.motor -= dampingOneWay * vRotor;
  if (bristle > 0) {
    // Dahl's model: the force builds up over a way of 0.02 rad.
    constexpr double way = 0.02;
    const double stiffness = bristle / way;
    if (qRotor - bristleAt > way) bristleAt = qRotor - way;
    if (qRotor - bristleAt < -way) bristleAt = qRotor + way;
    result.motor -= stiffness * (qRotor - bristleAt);
  }
  result.link = bias;
  result.link -= spring * (qLink - rest);
  if (cable > 0 && qLink > rest) result.link -= cable * (qLink - rest);
  if (isGeared()) {
    const double apart = qRotor - qLink, beyond = apart - std::clamp(apart, -play / 2, play / 2);
    if (beyond != 0) {
      result.gear = gearStiffness * beyond + gearDamping * (vRotor - vLink);
      if (result.gear * beyond < 0) result.gear = 0;  // teeth push, they do not pull
    }
    if (play == 0) result.gear = gearStiffness * apart + gearDamping * (vRotor - vLink);
  }
  const double s = vRotor / stribeckSpeed;
  result.friction = coulomb + stribeck * std::exp(-s * s) + load * std::abs(transmitted);
  begun = t;
  return result;
}

}  // namespace plumbline::reality
