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
      acceleration(plant.accelerationLimit),
      fastest(plant.profileSpeed) {
  if (!trial.stiffness[joint].empty()) stiffnesses = &trial.stiffness[joint];
  if (!trial.voltage[joint].empty()) voltages = &trial.voltage[joint];
  const auto sent = [&](const auto& of) {
    return joint < of.size() && !of[joint].empty() ? &of[joint] : nullptr;
  };
  speeds = sent(trial.commandSpeed);
  torques = sent(trial.commandTorque);
  straight = trial.linearCommands;
  currentAt = time.empty() ? 0 : time.front() + shift;
  current = profile = firstFinite(*command);
  if (stiffnesses) stiff = firstFinite(*stiffnesses);
  if (voltages) volts = firstFinite(*voltages);
}

/// What is sent with a cycle's command.
void CommandPath::take(std::size_t cycle) {
  const auto read = [cycle](const std::vector<double>* values, double& into) {
    if (values && std::isfinite((*values)[cycle])) into = (*values)[cycle];
  };
  read(stiffnesses, stiff);
  read(voltages, volts);
  read(speeds, sentSpeed);
  read(torques, sentTorque);
}

/// Mean of the straight lines from each command that came to the next.
double CommandPath::line(double from, double to) {
  const auto came = [&](std::size_t cycle) {
    return !(losable && lost && (*lost)[cycle]) && cycle < command->size() &&
           std::isfinite((*command)[cycle]);
  };
  double sum = 0, since = from;
  while (true) {
    std::size_t ahead = next;
    while (ahead < time.size() && !came(ahead)) ++ahead;
    const bool last = ahead == time.size();
    const double reached = last ? to : std::min(to, time[ahead] + shift);
    const double slope = last || time[ahead] + shift <= currentAt
                             ? 0
                             : ((*command)[ahead] - current) / (time[ahead] + shift - currentAt);
    if (reached > since) {
      sum += (current + slope * ((since + reached) / 2 - currentAt)) * (reached - since);
      since = reached;
    }
    if (last || time[ahead] + shift >= to) break;
    current = (*command)[ahead];
    currentAt = time[ahead] + shift;
    take(ahead);
    next = ahead + 1;
  }
  return to > from ? sum / (to - from) : current;
}

double CommandPath::target(double from, double to) {
  if (straight) return line(from, to);
  double sum = 0, since = from;
  while (next < time.size() && time[next] + shift < to) {
    const double when = std::max(time[next] + shift, from);
    if (!(losable && lost && (*lost)[next])) {
      if (next < command->size() && std::isfinite((*command)[next])) {
        sum += current * (when - since);
        since = when;
        current = (*command)[next];
      }
      take(next);
    }
    ++next;
  }
  return to > since ? (sum + current * (to - since)) / (to - from) : current;
}

double CommandPath::profileOver(double from, double to) {
  // The fastest approach that still can stop at the target (time-optimal, bang-bang).
  const double h = to - from, before = profile, error = target(from, to) - profile;
  if (acceleration <= 0) {
    const double way = std::clamp(error, -fastest * h, fastest * h);
    profile += way;
    // It moves for a part of the step, then it is there.
    return profile - way / 2 * std::abs(way) / (fastest * h);
  }
  double best = std::copysign(std::sqrt(2 * acceleration * std::abs(error)), error);
  if (fastest > 0) best = std::clamp(best, -fastest, fastest);
  const double limited = std::clamp(best, speed - acceleration * h, speed + acceleration * h);
  speed =
      std::abs(limited * h) > std::abs(error) && limited * error > 0 && std::abs(limited) <= acceleration * h
          ? error / h
          : limited;
  profile += speed * h;
  return (before + profile) / 2;
}

double CommandPath::over(double from, double to) {
  if (acceleration <= 0 && fastest <= 0) return target(from, to);
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / profileStep - 1e-9)));
  const double h = (to - from) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += profileOver(from + i * h, i + 1 == steps ? to : from + (i + 1) * h);
  return sum / steps;
}

}  // namespace plumbline::gap
