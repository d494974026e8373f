#include "simulation/servo/ServoDrive.h"

#include <algorithm>
#include <cmath>

namespace plumbline::simulation {

namespace {

constexpr double fadeShare = 0.1;  ///< of the top speed, over which the torque fades

}  // namespace

ServoDrive::ServoDrive(const JointPlant& plant_, bool detailed_)
    : plant(plant_), detailed(detailed_), behindGear(plant_.geared() && plant_.linkEncoder) {}

void ServoDrive::start(double q) {
  wanted = profile = shown(q);
  stiffness = 1;
  profileSpeed = heat = speedBefore = 0;
  supply = 1;
  load = {};
}

double ServoDrive::shown(double angle) const {
  const double q = angle - plant.offset;
  return plant.encoderAmplitude == 0 ? q : q + plant.encoderAmplitude * std::sin(q + plant.encoderPhase);
}

double ServoDrive::measured(const Side& motor, const Side& link) const {
  return shown(plant.linkEncoder ? link.position : motor.position);
}

/// The servo's own profile: as fast as it can still brake, no faster than it is set to or the motor turns.
void ServoDrive::follow(double h) {
  if (plant.accelerationLimit <= 0) {
    const double most = plant.profileSpeed * h;
    profile = most > 0 ? profile + std::clamp(wanted - profile, -most, most) : wanted;
    return;
  }
  constexpr int slices = 4;
  const double t = h / slices, most = plant.accelerationLimit * t;
  for (int i = 0; i < slices; ++i) {
    const double way = wanted - profile;
    double fastest = std::sqrt(2 * plant.accelerationLimit * std::abs(way));
    if (plant.maxSpeed > 0) fastest = std::min(fastest, plant.maxSpeed);
    if (plant.profileSpeed > 0) fastest = std::min(fastest, plant.profileSpeed);
    profileSpeed += std::clamp(std::copysign(fastest, way) - profileSpeed, -most, most);
    if (std::abs(way) < most * t && std::abs(profileSpeed) <= 2 * most) {
      profile = wanted;
      profileSpeed = 0;
    } else {
      profile += profileSpeed * t;
    }
  }
}

void ServoDrive::begin(double h, const Side& motor, const Side& link) {
  follow(h);
  step = h;
  speedBefore = motor.speed;
  regime = Regime::linear;
  error = profile - measured(motor, link);
  const Servo& servo = plant.servo;
  double kp = servo.kp, kd = servo.kd;
  if (detailed && servo.model == Servo::Model::dcMotor) {
    kp = servo.kt * servo.vin * plant.supplyFactor * supply * servo.kpFirmware * servo.errorGain / servo.R;
    kd = servo.kt * servo.kt / servo.R + plant.extraDamping;
  }
  if (plant.deadBand > 0) {
    if (std::abs(error) <= plant.deadBand)
      error = kp = 0;
    else if (!plant.deadBandSteps)
      error -= std::copysign(plant.deadBand, error);
  }
  law0 = stiffness * kp * error;
  if (behindGear) {
    law0 -= stiffness * kd * link.speed;
    law1 = 0;
  } else if (detailed) {
    // Speeds by the trapezoid, positions half a step ahead of them (leapfrog).
    law1 = stiffness * kd / 2;
    law0 -= law1 * motor.speed;
  } else {
    // The error at the end of the step is smaller by what the joint moves until then.
    law1 = stiffness * (kd + h * kp);
  }
}

double ServoDrive::fullLimit() const {
  const double most =
      stiffness * plant.maxTorque * (plant.torqueFactor * std::max(0.0, 1 - plant.deratingPerJoule * heat));
  // A DC motor's law has the supply in it.
  return plant.servo.model == Servo::Model::dcMotor ? most : most * supply;
}

/// Most torque in the direction of sign at this speed: it fades over the last tenth below the top speed.
double ServoDrive::limit(double sign, double speed) const {
  const double top = topSpeed();
  const double fade = top > 0 ? std::clamp((top - sign * speed) / (fadeShare * top), 0.0, 1.0) : 1.0;
  return fullLimit() * fade;
}

bool ServoDrive::limitAt(double speedAfter) {
  const Servo& servo = plant.servo;
  const bool dc = servo.model == Servo::Model::dcMotor;
  const double torqueNow = torque(speedAfter);
  if (regime == Regime::linear && dc) {
    const double asked = detailed ? error : error - step * speedAfter;
    const double duty = servo.kpFirmware * servo.errorGain * asked;
    if (std::abs(duty) > servo.maxPwm) {
      regime = Regime::fullDuty;
      sense = torqueNow < 0 ? -1 : 1;
      if (detailed) sense = duty < 0 ? -1 : 1;
      law0 =
          sense * stiffness * servo.kt * (servo.vin * plant.supplyFactor * supply) * servo.maxPwm / servo.R;
      law1 = stiffness * (servo.kt * servo.kt / servo.R + plant.extraDamping);
      return true;
    }
  }
  if (dc && plant.torqueFactor >= 1 && plant.deratingPerJoule <= 0) return false;
  if (regime == Regime::linear || regime == Regime::fullDuty) {
    sense = torqueNow < 0 ? -1 : 1;
    const bool fades = !dc && detailed;
    const double most = dc ? fullLimit() : limit(sense, fades ? speedAfter : speedBefore);
    if (std::abs(torqueNow) <= most) return false;
    regime = fades ? Regime::limited : Regime::spent;
    law1 = 0;
    law0 = sense * (fades ? fullLimit() : most);
    return true;
  }
  // Only what is detailed comes here: full torque, then on the fading line, then none.
  const double ahead = sense * speedAfter / std::max(1e-9, topSpeed());
  if (regime == Regime::limited && topSpeed() > 0 && ahead > 1 - fadeShare) {
    regime = Regime::faded;
    law1 = fullLimit() / (fadeShare * topSpeed());
    law0 = sense * law1 * topSpeed();
    return true;
  }
  if (regime == Regime::faded && ahead > 1) {
    regime = Regime::spent;
    law0 = law1 = 0;
    return true;
  }
  return false;
}

void ServoDrive::end(double speedAfter, double friction) {
  load.motor = torque(speedAfter);
  const double work = plant.heatIsWork ? std::abs(load.motor * speedAfter) : load.motor * load.motor;
  heat += work * step;
  load.gear = load.motor - plant.servo.armature * (speedAfter - speedBefore) / step;
  load.link = load.gear + friction;
}

DryFriction ServoDrive::dryLimit() const { return dryFriction(plant, speedBefore, load); }

}  // namespace plumbline::simulation
