#include "gap/replay/Restarts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace plumbline::gap {

namespace {

constexpr double leastSeconds = 1, mostSeconds = 1.5;  // apart: in the middle of a step, or anywhere
constexpr double leastShareOfLoad = 0.9;               // of what all feet carry: the robot is on this foot
constexpr int leastSteps = 4;                          // changes from one foot to another
constexpr double secondsBefore = 0.06, secondsAfter = 0.03;  // a landing or lift-off shakes the body
constexpr double mostShiftOfLoad = 0.03;                     // more is a landing or lift-off
constexpr int halfWindow = 2;  // cycles on either side that a speed is taken from

/// Per cycle and foot, its share of what all feet carry; empty where no foot is pressed or a sample was lost.
std::vector<std::vector<double>> loadShares(const Trial& trial) {
  std::vector<std::vector<double>> shares(trial.cycles(), std::vector<double>(trial.robot->feet.size(), 0));
  for (const Signal& signal : trial.signals) {
    if (signal.kind != SignalKind::force) continue;
    for (std::size_t k = 0; k < trial.cycles(); ++k)
      shares[k][static_cast<std::size_t>(signal.place)] += signal.values[k];
  }
  for (std::vector<double>& cycle : shares) {
    double all = 0;
    for (const double load : cycle) all += load;
    if (!(all > 0)) {
      cycle.clear();
      continue;
    }
    for (double& load : cycle) load /= all;
  }
  return shares;
}

/// The foot that carries nearly everything, or -1.
int standsOn(const std::vector<double>& shares) {
  const auto most = std::ranges::max_element(shares);
  return most != shares.end() && *most >= leastShareOfLoad ? static_cast<int>(most - shares.begin()) : -1;
}

/// Slope of a straight line through the samples around a cycle; NaN next to gaps.
double slopeAt(const Trial& trial, const std::vector<double>& values, std::size_t k) {
  if (k < halfWindow || k + halfWindow >= values.size()) return std::numeric_limits<double>::quiet_NaN();
  double n = 0, t = 0, x = 0, tt = 0, tx = 0;
  for (std::size_t i = k - halfWindow; i <= k + halfWindow; ++i) {
    const double when = trial.time[i] - trial.time[k];
    n += 1, t += when, x += values[i], tt += when * when, tx += when * values[i];
  }
  return (n * tx - t * x) / (n * tt - t * t);
}

Restart restartAt(const Trial& trial, std::size_t k, std::vector<double> load) {
  const std::size_t joints = trial.robot->joints.size();
  Restart restart{
      k, std::vector<double>(joints, std::numeric_limits<double>::quiet_NaN()), {}, std::move(load)};
  restart.speed = restart.position;
  for (const Signal& signal : trial.signals) {
    if (signal.kind != SignalKind::position) continue;
    const auto j = static_cast<std::size_t>(signal.joint);
    restart.speed[j] = slopeAt(trial, signal.values, k);
    restart.position[j] = signal.values[k] - trial.positionAt[j] * restart.speed[j];
  }
  return restart;
}

/// Whether load stays where it is from a little before the cycle to a little after it.
bool isBetweenSteps(const Trial& trial, const std::vector<std::vector<double>>& shares, std::size_t k) {
  const auto from = std::ranges::lower_bound(trial.time, trial.time[k] - secondsBefore) - trial.time.begin();
  const auto to = std::ranges::upper_bound(trial.time, trial.time[k] + secondsAfter) - trial.time.begin();
  const std::span around(shares.begin() + from, shares.begin() + to);
  if (std::ranges::any_of(around, &std::vector<double>::empty)) return false;
  for (std::size_t foot = 0; foot < trial.robot->feet.size(); ++foot) {
    const auto [least, most] = std::ranges::minmax_element(
        around, {}, [&](const std::vector<double>& loads) { return loads[foot]; });
    if ((*most)[foot] - (*least)[foot] > mostShiftOfLoad) return false;
  }
  return true;
}

}  // namespace

void cutIntoSteps(Trial& trial) {
  if (!trial.freeBase || trial.cycles() <= 2 * halfWindow) return;
  const std::vector<std::vector<double>> shares = loadShares(trial);
  std::vector<Restart> restarts;
  const auto sinceLast = [&](std::size_t k) {
    return restarts.empty() ? INFINITY : trial.time[k] - trial.time[restarts.back().cycle];
  };
  int steps = 0, last = -1;
  for (std::size_t k = halfWindow; k + halfWindow < trial.cycles();) {
    const int foot = standsOn(shares[k]);
    std::size_t end = k + 1;
    if (foot >= 0) {
      while (end < trial.cycles() && standsOn(shares[end]) == foot) ++end;
      if (last >= 0 && foot != last) ++steps;
      last = foot;
      const std::size_t middle = (k + end) / 2;
      if (sinceLast(middle) >= leastSeconds) restarts.push_back(restartAt(trial, middle, shares[middle]));
    } else if (!shares[k].empty() && sinceLast(k) >= mostSeconds) {
      restarts.push_back(restartAt(trial, k, shares[k]));
    }
    k = end;
  }
  if (steps < leastSteps) return;
  trial.restarts = std::move(restarts);
  trial.betweenSteps.assign(trial.cycles(), 0);
  for (std::size_t k = 0; k < trial.cycles(); ++k) trial.betweenSteps[k] = isBetweenSteps(trial, shares, k);
}

}  // namespace plumbline::gap
