#include "gap/replay/CommandPath.h"

#include <algorithm>
#include <cmath>

namespace plumbline::gap {

namespace {

constexpr double profileStep = 0.00025;  // [s]: servos run their profiles far faster than a replay's steps

double firstFinite(const std::vector<double>& values) {
  for (const double value : values)
    if (std::isfinite(value)) return value;
  return 0;
}

}  // namespace

CommandPath::CommandPath(const JointPlant& plant, const Trial& trial, std::size_t joint,
                         const std::vector<std::uint8_t>* lostCycles)
    : command(&trial.targets(joint)),
      time(trial.time),
      lost(lostCycles),
      losable(!trial.command[joint].empty()),
      shift(trial.commandAt[joint] + plant.commandDelay),
      acceleration(plant.accelerationLimit) {
  if (!trial.stiffness[joint].empty()) stiffnesses = &trial.stiffness[joint];
  if (!trial.voltage[joint].empty()) voltages = &trial.voltage[joint];
  current = profile = firstFinite(*command);
  if (stiffnesses) stiff = firstFinite(*stiffnesses);
  if (voltages) volts = firstFinite(*voltages);
}

double CommandPath::target(double from, double to) {
  double sum = 0, since = from;
  while (next < time.size() && time[next] + shift < to) {
    const double when = std::max(time[next] + shift, from);
    if (!(losable && lost && (*lost)[next])) {
      if (next < command->size() && std::isfinite((*command)[next])) {
        sum += current * (when - since);
        since = when;
        current = (*command)[next];
      }
      if (stiffnesses && std::isfinite((*stiffnesses)[next])) stiff = (*stiffnesses)[next];
      if (voltages && std::isfinite((*voltages)[next])) volts = (*voltages)[next];
    }
    ++next;
  }
  return to > since ? (sum + current * (to - since)) / (to - from) : current;
}

double CommandPath::profileOver(double from, double to) {
  // The fastest approach that still can stop at the target (time-optimal, bang-bang).
  const double h = to - from, before = profile, error = target(from, to) - profile;
  const double best = std::copysign(std::sqrt(2 * acceleration * std::abs(error)), error);
  const double limited = std::clamp(best, speed - acceleration * h, speed + acceleration * h);
  speed =
      std::abs(limited * h) > std::abs(error) && limited * error > 0 && std::abs(limited) <= acceleration * h
          ? error / h
          : limited;
  profile += speed * h;
  return (before + profile) / 2;
}

double CommandPath::over(double from, double to) {
  if (acceleration <= 0) return target(from, to);
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / profileStep - 1e-9)));
  const double h = (to - from) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += profileOver(from + i * h, i + 1 == steps ? to : from + (i + 1) * h);
  return sum / steps;
}

}  // namespace plumbline::gap
