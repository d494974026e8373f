#include "gap/diagnosis/Phases.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::gap {

namespace {

constexpr double reversalSeconds = 0.15;
constexpr double stillSpeed = 0.02;   // [rad/s] of the command
constexpr double turnSpeed = 0.05;    // [rad/s]: slower is no direction yet
constexpr double highShare = 0.5;     // of a joint's limit
constexpr double supportShare = 0.8;  // of the weight on one foot
constexpr double impactJump = 0.3;    // of the weight, within a cycle

std::vector<Phase> jointPhases(const Trial& trial, const Signal& signal) {
  const auto& joint = trial.robot->joints[static_cast<std::size_t>(signal.joint)];
  const auto& command = trial.targets(static_cast<std::size_t>(signal.joint));
  const Signal* const position = positionOf(trial, signal.joint);
  const auto& values = position ? position->values : signal.values;
  std::vector<Phase> phases(trial.cycles(), Phase::motion);
  std::vector<double> reversals;
  double direction = 0;
  constexpr std::size_t reach = 3;
  const auto rate = [&](const std::vector<double>& series, std::size_t k) {
    const std::size_t a = k >= reach ? k - reach : 0, b = std::min(k + reach, series.size() - 1);
    const double h = trial.time[b] - trial.time[a];
    return h > 0 ? (series[b] - series[a]) / h : 0;
  };
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    const double speed = rate(values, k), wanted = rate(command, k);
    if (std::abs(wanted) < stillSpeed && !(std::abs(speed) > turnSpeed)) phases[k] = Phase::staticHold;
    if (joint.maxSpeed > 0 && std::abs(speed) > highShare * joint.maxSpeed) phases[k] = Phase::highSpeed;
    if (joint.maxTorque > 0 &&
        std::abs(joint.servo.kp * (command[k] - values[k])) > highShare * joint.maxTorque)
      phases[k] = Phase::highLoad;
    if (std::abs(speed) > turnSpeed) {
      const double sign = speed > 0 ? 1 : -1;
      if (direction * sign < 0) reversals.push_back(trial.time[k]);
      direction = sign;
    }
  }
  for (const double when : reversals) {
    auto k = static_cast<std::size_t>(std::ranges::lower_bound(trial.time, when - reversalSeconds) -
                                      trial.time.begin());
    for (; k < trial.cycles() && trial.time[k] <= when + reversalSeconds; ++k) phases[k] = Phase::reversal;
  }
  return phases;
}

std::vector<Phase> bodyPhases(const Trial& trial) {
  std::vector<Phase> phases(trial.cycles(), Phase::motion);
  const auto& feet = trial.robot->feet;
  if (!trial.freeBase) return std::vector<Phase>(trial.cycles(), Phase::staticHold);
  std::vector<std::vector<double>> load(feet.size(), std::vector<double>(trial.cycles(), 0));
  bool any = false;
  for (const Signal& signal : trial.signals)
    if (signal.kind == SignalKind::force) {
      any = true;
      for (std::size_t k = 0; k < trial.cycles(); ++k)
        if (std::isfinite(signal.values[k]))
          load[static_cast<std::size_t>(signal.place)][k] += signal.values[k];
    }
  if (!any || feet.size() != 2) return phases;
  const std::size_t left = feet[0].name.starts_with('R') ? 1 : 0, right = 1 - left;
  const double weight = trial.robot->totalMass() * trial.robot->gravity.norm();
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    const double sum = load[left][k] + load[right][k];
    if (sum > 0 && load[left][k] > supportShare * sum) phases[k] = Phase::leftSupport;
    if (sum > 0 && load[right][k] > supportShare * sum) phases[k] = Phase::rightSupport;
    for (const std::size_t foot : {left, right})
      if (k > 0 && std::abs(load[foot][k] - load[foot][k - 1]) > impactJump * weight)
        phases[k] = Phase::impact;
  }
  return phases;
}

}  // namespace

std::string_view nameOf(Phase phase) {
  constexpr std::array<std::string_view, numPhases> names{"static hold",   "reversal", "high speed",
                                                          "high load",     "impact",   "left support",
                                                          "right support", "motion"};
  return names[static_cast<std::size_t>(phase)];
}

std::vector<Phase> phasesOf(const Trial& trial, const Signal& signal) {
  return signal.joint >= 0 ? jointPhases(trial, signal) : bodyPhases(trial);
}

}  // namespace plumbline::gap
