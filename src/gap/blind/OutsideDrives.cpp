#include "gap/blind/OutsideDrives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

namespace {

constexpr double teeth = 24;         ///< ripples per turn
constexpr double phase = 0.7;        ///< of the ripple [rad]
constexpr double bristleWay = 0.02;  ///< over which a bristle's force builds up [rad]
constexpr double driftTime = 15;     ///< in which a gain falls [s]

using Drive = OutsideDrive;
using Where = DrawRange::Where;
using Unit = DrawRange::Unit;

constexpr std::array outsideLibrary{
    OutsideEffect{
        "gear_ripple", {.where = Where::joint, .low = .08, .high = .2, .unit = Unit::torque}, &Drive::ripple},
    OutsideEffect{
        "joint_spring", {.where = Where::joint, .low = .1, .high = .4, .unit = Unit::torque}, &Drive::spring},
    OutsideEffect{
        "cable_spring", {.where = Where::joint, .low = .15, .high = .5, .unit = Unit::torque}, &Drive::cable},
    OutsideEffect{"asymmetric_damping",
                  {.where = Where::joint, .low = .5, .high = 1.5, .unit = Unit::damping},
                  &Drive::dampingOneWay},
    OutsideEffect{"gain_drift", {.where = Where::joint, .low = .3, .high = .6}, &Drive::drift},
    OutsideEffect{"servo_integral", {.where = Where::joint, .low = 1, .high = 4}, &Drive::integral},
    OutsideEffect{"command_resolution", {.where = Where::joint, .low = .01, .high = .03}, &Drive::resolution},
    OutsideEffect{"crosstalk", {.where = Where::joint, .low = .05, .high = .2}, &Drive::crosstalk},
    OutsideEffect{"bristle_friction",
                  {.where = Where::joint, .low = .05, .high = .15, .unit = Unit::torque},
                  &Drive::bristle},
    OutsideEffect{"acc_bias",
                  {.where = Where::imu, .low = .4, .high = 1.2, .bothSigns = true, .axes = "xyz"}},
};

}  // namespace

std::span<const OutsideEffect> outsideEffects() { return outsideLibrary; }

const OutsideEffect* findOutsideEffect(std::string_view id) {
  const auto* const it = std::ranges::find(outsideLibrary, id, &OutsideEffect::id);
  return it == outsideLibrary.end() ? nullptr : it;
}

OutsideDrives::OutsideDrives(const Mechanism& robot, const std::vector<BlindEffect>& effects)
    : robot_(robot), drives_(robot.joints.size()) {
  for (const BlindEffect& e : effects) {
    const OutsideEffect* effect = findOutsideEffect(e.effect);
    if (!effect) throw std::runtime_error("no engine of this program has the effect " + e.effect);
    if (!effect->size) {
      bias_ += e.value * unitVector(e.axis.at(0));
      continue;
    }
    const int at = robot_.jointIndex(e.at);
    if (at < 0) throw std::runtime_error(e.effect + ": " + robot_.name + " has no joint " + e.at);
    for (int j = 0; j < robot_.numJoints(); ++j) {
      if (robot_.motorOf(j) != robot_.motorOf(at)) continue;
      drives_[static_cast<std::size_t>(j)].*effect->size += e.value;
    }
  }
}

void OutsideDrives::start(const std::vector<double>& commands) {
  for (std::size_t j = 0; j < drives_.size(); ++j) drives_[j].rest = drives_[j].bristleAt = commands[j];
}

void OutsideDrives::act(double time, double h, servo::RobotSimulation& world, std::vector<double>& targets) {
  const std::vector<double> asked = targets;
  for (std::size_t j = 0; j < drives_.size(); ++j) {
    const auto joint = static_cast<int>(j);
    world.load(joint, torque(drives_[j], world.readings().position[j], world.readings().velocity[j]));
    targets[j] = targetFor(drives_[j], j, time, h, world.encoder(joint), asked);
  }
}

double OutsideDrives::torque(Drive& drive, double q, double speed) const {
  double sum = drive.ripple * std::sin(teeth * q + phase) - drive.spring * (q - drive.rest) -
               drive.cable * std::max(0.0, q - drive.rest) - drive.dampingOneWay * std::max(0.0, speed);
  if (drive.bristle > 0) {
    // Bent as far as it gives, then dragged along (Dahl's model with straight flanks).
    drive.bristleAt = std::clamp(drive.bristleAt, q - bristleWay, q + bristleWay);
    sum -= drive.bristle / bristleWay * (q - drive.bristleAt);
  }
  return sum;
}

/// The command that makes this servo act as one with another law: its integral, its weaker gain,
/// its steps, its neighbour's share.
double OutsideDrives::targetFor(Drive& drive, std::size_t j, double time, double h, double measured,
                                const std::vector<double>& targets) const {
  double target = targets[j];
  if (drive.crosstalk != 0) {
    const int parent = robot_.joints[j].parent;
    const std::size_t other =
        parent > 0 ? static_cast<std::size_t>(parent) - 1 : std::min(j + 1, drives_.size() - 1);
    target += drive.crosstalk * (targets[other] - drives_[other].rest);
  }
  if (drive.resolution > 0) target = std::round(target / drive.resolution) * drive.resolution;
  if (drive.integral > 0) {
    const double most = robot_.joints[j].maxTorque / robot_.joints[j].servo.kp;  // against winding up
    drive.summed = std::clamp(drive.summed + drive.integral * (target - measured) * h, -most, most);
    target += drive.summed;
  }
  if (drive.drift == 0) return target;
  const double gain = 1 - drive.drift * std::clamp(time / driftTime, 0.0, 1.0);
  return measured + gain * (target - measured);
}

}  // namespace plumbline::gap
