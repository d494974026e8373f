#include "gap/inference/Stretches.h"

#include <algorithm>
#include <cmath>

namespace plumbline::gap {

namespace {

constexpr double startSeconds = 0.3;
constexpr double rounding = 1e-9;  // of shares that are added up

/// Adds the way from each value to the next.
void addTravel(const std::vector<double>& angles, std::vector<double>& travel) {
  for (std::size_t k = 1; k < std::min(angles.size(), travel.size()); ++k)
    if (const double way = std::abs(angles[k] - angles[k - 1]); std::isfinite(way)) travel[k] += way;
}

}  // namespace

std::size_t firstScored(const Trial& trial) {
  return static_cast<std::size_t>(std::ranges::lower_bound(trial.time, trial.time.front() + startSeconds) -
                                  trial.time.begin());
}

std::vector<std::size_t> stretchesOf(const Trial& trial, std::size_t parts) {
  const std::size_t first = firstScored(trial), cycles = trial.cycles();
  std::vector<double> travel(cycles, 0.0);
  for (const std::vector<double>& command : trial.command) addTravel(command, travel);
  for (const Signal& signal : trial.signals)
    if (signal.kind == SignalKind::position) addTravel(signal.values, travel);
  double all = 0;
  for (std::size_t k = first; k < cycles; ++k) all += travel[k];
  const auto count = static_cast<double>(cycles - first);
  std::vector<std::size_t> bounds{first};
  double share = 0;
  for (std::size_t k = first; k < cycles; ++k) {
    if (share > static_cast<double>(bounds.size()) / static_cast<double>(parts) - rounding &&
        bounds.size() < parts)
      bounds.push_back(k);
    share += all > 0 ? 0.5 / count + 0.5 * travel[k] / all : 1 / count;
  }
  bounds.resize(parts + 1, cycles);
  return bounds;
}

}  // namespace plumbline::gap
