#include "servo/ServoDrive.h"

#include <algorithm>
#include <cmath>

namespace plumbline::servo {

ServoDrive::ServoDrive(const JointPlant& plant, bool detailed)
    : plant_(plant), detailed_(detailed), behindGear_(plant.geared() && plant.linkEncoder) {}

void ServoDrive::start(double q) {
  wanted_ = behindLag_ = profile_ = shown(q);
  stiffness_ = 1;
  profileSpeed_ = heat_ = speedBefore_ = 0;
  supply_ = 1;
  load_ = {};
}

double ServoDrive::shown(double angle) const {
  const double q = angle - plant_.offset;
  return plant_.encoderAmplitude == 0 ? q : q + plant_.encoderAmplitude * std::sin(q + plant_.encoderPhase);
}

double ServoDrive::measured(const Side& motor, const Side& link) const {
  return shown(plant_.linkEncoder ? link.position : motor.position);
}

/// Mean over a step of what the servo's filter makes of its command.
double ServoDrive::filtered(double h) {
  const double lag = plant_.commandLag;
  if (lag <= 0) return wanted_;
  const double away = behindLag_ - wanted_, fades = std::expm1(-h / lag);
  behindLag_ = wanted_ + away * (1 + fades);
  return wanted_ - away * lag / h * fades;
}

/// The servo's own profile: as fast as it can still brake, no faster than it is set to or the motor turns.
void ServoDrive::follow(double h) {
  const double goal = filtered(h);
  if (plant_.accelerationLimit <= 0) {
    const double most = plant_.profileSpeed * h;
    profile_ = most > 0 ? profile_ + std::clamp(goal - profile_, -most, most) : goal;
    return;
  }
  constexpr int slices = 4;
  const double t = h / slices, most = plant_.accelerationLimit * t;
  for (int i = 0; i < slices; ++i) {
    const double way = goal - profile_;
    double fastest = std::sqrt(2 * plant_.accelerationLimit * std::abs(way));
    if (plant_.maxSpeed > 0) fastest = std::min(fastest, plant_.maxSpeed);
    if (plant_.profileSpeed > 0) fastest = std::min(fastest, plant_.profileSpeed);
    profileSpeed_ += std::clamp(std::copysign(fastest, way) - profileSpeed_, -most, most);
    if (std::abs(way) < most * t && std::abs(profileSpeed_) <= 2 * most) {
      profile_ = goal;
      profileSpeed_ = 0;
    } else {
      profile_ += profileSpeed_ * t;
    }
  }
}

void ServoDrive::begin(double h, const Side& motor, const Side& link) {
  follow(h);
  step_ = h;
  speedBefore_ = motor.speed;
  linkSpeed_ = link.speed;
  regime_ = Regime::linear;
  error_ = profile_ - measured(motor, link);
  const Servo& servo = plant_.servo;
  double kp = servo.kp, kd = servo.kd;
  if (detailed_ && servo.model == Servo::Model::dcMotor) {
    kp = servo.kt * servo.vin * plant_.supplyFactor * supply_ * servo.kpFirmware * servo.errorGain / servo.R;
    kd = servo.kt * servo.kt / servo.R + plant_.extraDamping;
  }
  if (plant_.deadBand > 0) {
    if (std::abs(error_) <= plant_.deadBand)
      error_ = kp = 0;
    else if (!plant_.deadBandSteps)
      error_ -= std::copysign(plant_.deadBand, error_);
  }
  law0_ = stiffness_ * kp * error_;
  if (behindGear_) {
    law0_ -= stiffness_ * kd * link.speed;
    law1_ = 0;
  } else if (detailed_) {
    // Speeds by the trapezoid, positions half a step ahead of them (leapfrog).
    law1_ = stiffness_ * kd / 2;
    law0_ -= law1_ * motor.speed;
  } else {
    // The error at the end of the step is smaller by what the joint moves until then.
    law1_ = stiffness_ * (kd + h * kp);
  }
}

/// Share of its limit that a weak motor has, and its heat leaves.
double ServoDrive::limitShare() const {
  return plant_.torqueFactor * std::max(0.0, 1 - plant_.deratingPerJoule * heat_);
}

double ServoDrive::fullLimit() const {
  const double most = stiffness_ * plant_.maxTorque * limitShare();
  // A DC motor's law has the supply in it.
  return plant_.servo.model == Servo::Model::dcMotor ? most : most * supply_;
}

/// Most torque in the direction of sign at this speed: it fades over the last part below the top speed.
double ServoDrive::limit(double sign, double speed) const {
  const double top = topSpeed();
  const double fade =
      top > 0 ? std::clamp((top - sign * speed) / (JointPlant::fadeShare * top), 0.0, 1.0) : 1.0;
  return fullLimit() * fade;
}

/// Of a position servo: full duty where the error asks for more than it gives.
bool ServoDrive::limitDutyAt(double speedAfter) {
  if (regime_ != Regime::linear) return false;
  const double most = stiffness_ * plant_.fullDutyTorque * supply_ * limitShare();
  const double damping = stiffness_ * plant_.servo.kd;
  const double error = detailed_ || behindGear_ ? error_ : error_ - step_ * speedAfter;
  const double asked = stiffness_ * plant_.servo.kp * error;
  if (std::abs(asked) <= most) return false;
  regime_ = Regime::fullDuty;
  sense_ = asked < 0 ? -1 : 1;
  law0_ = sense_ * most;
  law1_ = 0;
  if (behindGear_)
    law0_ -= damping * linkSpeed_;
  else if (detailed_)
    law0_ -= damping / 2 * speedBefore_, law1_ = damping / 2;
  else
    law1_ = damping;
  return true;
}

bool ServoDrive::limitAt(double speedAfter) {
  const Servo& servo = plant_.servo;
  const bool dc = servo.model == Servo::Model::dcMotor;
  if (!dc && plant_.fullDutyTorque > 0) return limitDutyAt(speedAfter);
  const double torqueNow = torque(speedAfter);
  if (regime_ == Regime::linear && dc) {
    const double asked = detailed_ ? error_ : error_ - step_ * speedAfter;
    const double duty = servo.kpFirmware * servo.errorGain * asked;
    if (std::abs(duty) > plant_.mostDuty()) {
      regime_ = Regime::fullDuty;
      sense_ = torqueNow < 0 ? -1 : 1;
      if (detailed_) sense_ = duty < 0 ? -1 : 1;
      law0_ = sense_ * stiffness_ * servo.kt * (servo.vin * plant_.supplyFactor * supply_) *
              plant_.mostDuty() / servo.R;
      law1_ = stiffness_ * (servo.kt * servo.kt / servo.R + plant_.extraDamping);
      return true;
    }
  }
  if (dc && plant_.torqueFactor >= 1 && plant_.deratingPerJoule <= 0) return false;
  if (regime_ == Regime::linear || regime_ == Regime::fullDuty) {
    sense_ = torqueNow < 0 ? -1 : 1;
    const bool fades = !dc && detailed_;
    const double most = dc ? fullLimit() : limit(sense_, fades ? speedAfter : speedBefore_);
    if (std::abs(torqueNow) <= most) return false;
    regime_ = fades ? Regime::limited : Regime::spent;
    law1_ = 0;
    law0_ = sense_ * (fades ? fullLimit() : most);
    return true;
  }
  // Only what is detailed comes here: full torque, then on the fading line, then none.
  const double ahead = sense_ * speedAfter / std::max(1e-9, topSpeed());
  if (regime_ == Regime::limited && topSpeed() > 0 && ahead > 1 - JointPlant::fadeShare) {
    regime_ = Regime::faded;
    law1_ = fullLimit() / (JointPlant::fadeShare * topSpeed());
    law0_ = sense_ * law1_ * topSpeed();
    return true;
  }
  if (regime_ == Regime::faded && ahead > 1) {
    regime_ = Regime::spent;
    law0_ = law1_ = 0;
    return true;
  }
  return false;
}

void ServoDrive::end(double speedAfter, double friction) {
  load_.motor = torque(speedAfter);
  const double work = plant_.heatIsWork ? std::abs(load_.motor * speedAfter) : load_.motor * load_.motor;
  heat_ += work * step_;
  load_.gear = load_.motor - plant_.servo.armature * (speedAfter - speedBefore_) / step_;
  load_.link = load_.gear + friction;
}

DryFriction ServoDrive::dryLimit() const { return dryFriction(plant_, speedBefore_, load_); }

}  // namespace plumbline::servo
