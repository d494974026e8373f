#include "gap/diagnosis/HoldHint.h"

#include <fmt/format.h>
#include <cmath>

#include "gap/diagnosis/Explanation.h"
#include "gap/replay/Replay.h"

namespace plumbline::gap {

namespace {

constexpr double mostLeft = 0.5;  // of the squares that held commands leave

struct Left {
  double squares = 0, samples = 0;

  double rms() const { return samples > 0 ? std::sqrt(squares / samples) : 0; }
};

void add(const Trial& trial, Left& left) {
  const Prediction nominal = replay(plantOf(trial, {}), trial);
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    if (trial.signals[s].kind != SignalKind::position || nominal.values[s].empty()) continue;
    for (std::size_t k = 0; k < trial.cycles(); ++k) {
      const double r = trial.signals[s].values[k] - nominal.values[s][k];
      if (std::isfinite(r)) left.squares += r * r, ++left.samples;
    }
  }
}

}  // namespace

std::string holdHint(const std::vector<Trial>& trials) {
  Left held, moved;
  for (const Trial& trial : trials) {
    if (trial.freeBase || trial.linearCommands) continue;
    add(trial, held);
    Trial linear = trial;
    linear.linearCommands = true;
    add(linear, moved);
  }
  if (moved.squares >= mostLeft * held.squares) return "";
  return fmt::format(
      "commands seem to move between the lines of these logs: then the nominal model is off by {:.2g} mrad "
      "instead of {:.2g} (mm for sliding joints); if the controller is faster than its log, use --hold "
      "linear",
      1e3 * moved.rms(), 1e3 * held.rms());
}

}  // namespace plumbline::gap
