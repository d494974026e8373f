#include "gap/replay/CurrentSide.h"

#include <algorithm>
#include <cmath>

#include "gap/replay/ServoLaw.h"

namespace plumbline::gap {

namespace {

/// Squared correlation of two series where both are measured; 0 where one does not vary.
double agreement(const std::vector<double>& a, const std::vector<double>& b) {
  double n = 0, sumA = 0, sumB = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!std::isfinite(a[k]) || !std::isfinite(b[k])) continue;
    ++n, sumA += a[k], sumB += b[k], aa += a[k] * a[k], bb += b[k] * b[k], ab += a[k] * b[k];
  }
  if (n < 3) return 0;
  const double varA = aa - sumA * sumA / n, varB = bb - sumB * sumB / n, both = ab - sumA * sumB / n;
  return varA > 1e-12 * aa && varB > 1e-12 * bb ? both * both / (varA * varB) : 0;
}

const Signal* positionOf(const Trial& trial, int joint) {
  const auto at = std::ranges::find_if(trial.signals, [&](const Signal& signal) {
    return signal.kind == SignalKind::position && signal.joint == joint;
  });
  return at == trial.signals.end() ? nullptr : &*at;
}

bool mayBeOfSupply(const Trial& trial, const Signal& signal) {
  if (signal.kind != SignalKind::current || !signal.unsignedValue) return false;
  const Servo& servo = trial.robot->joints[static_cast<std::size_t>(signal.joint)].servo;
  return servo.kt > 0 && servo.R > 0 && servo.vin > 0;
}

/// Sums of squared correlations over a trial's joints.
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
  sides.motor += agreement(signal.values, motor);
  sides.supply += agreement(signal.values, supply);
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
