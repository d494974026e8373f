#include "gap/replay/CurrentSide.h"

#include <algorithm>
#include <cmath>

#include "gap/replay/ServoLaw.h"

namespace plumbline::gap {

namespace {

constexpr double leastScale = 1.0 / 3, mostScale = 3;  // of a reported current, that a servo may be off by

/// Log likelihood of readings of a predicted series, at the likeliest scale and noise.
double likelihood(const std::vector<double>& readings, const std::vector<double>& predicted) {
  double n = 0, squares = 0, product = 0, ofPredicted = 0;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const double reading = std::abs(readings[k]), p = predicted[k];
    if (!std::isfinite(reading) || !std::isfinite(p)) continue;
    ++n, squares += reading * reading, product += reading * p, ofPredicted += p * p;
  }
  if (!(squares > 0) || !(ofPredicted > 0)) return 0;
  const double scale = std::clamp(product / ofPredicted, leastScale, mostScale);
  const double left = squares - 2 * scale * product + scale * scale * ofPredicted;
  return -n / 2 * std::log(std::max(left / squares, 1e-9));
}

bool mayBeOfSupply(const Trial& trial, const Signal& signal) {
  if (signal.kind != SignalKind::current || !signal.unsignedValue) return false;
  const Servo& servo = trial.robot->joints[static_cast<std::size_t>(signal.joint)].servo;
  return servo.kt > 0 && servo.R > 0 && servo.vin > 0;
}

/// Log likelihoods of the two currents.
struct Sides {
  double motor = 0, supply = 0;
};

void compare(const Trial& trial, const Signal& signal, Sides& sides) {
  const Signal* const position = positionOf(trial, signal.joint);
  const auto joint = static_cast<std::size_t>(signal.joint);
  const std::vector<double>& targets = trial.targets(joint);
  if (!position || targets.empty()) return;
  const JointPlant plant = JointPlant::nominal(trial.robot->joints[joint]);
  std::vector<double> motor, supply;
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    const double volts = trial.voltage[joint].empty() ? 0 : trial.voltage[joint][k];
    const double angle = position->values[k], rate = rateAt(trial, *position, k);
    const double amperes =
        servoLine(plant, targets[k], 1, volts, angle, rate, 1).at(angle, rate) / plant.servo.kt;
    motor.push_back(std::abs(amperes));
    supply.push_back(std::abs(amperes * dutyThatDraws(plant, amperes, rate, volts)));
  }
  sides.motor += likelihood(signal.values, motor);
  sides.supply += likelihood(signal.values, supply);
}

}  // namespace

void findCurrentSide(std::vector<Trial>& trials) {
  Sides sides;
  for (const Trial& trial : trials)
    for (const Signal& signal : trial.signals)
      if (mayBeOfSupply(trial, signal)) compare(trial, signal, sides);
  for (Trial& trial : trials)
    for (Signal& signal : trial.signals)
      if (mayBeOfSupply(trial, signal)) signal.ofSupply = sides.supply > sides.motor;
}

}  // namespace plumbline::gap
