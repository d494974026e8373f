#include "gap/replay/Replay.h"

#include <limits>

#include "gap/replay/Playback.h"
#include "gap/replay/Restarts.h"

namespace plumbline::gap {

namespace {

/// What is read while a robot that was put into another state comes to rest on its feet is no prediction.
void leaveSettlingOut(const Trial& trial, Prediction& prediction) {
  if (!trial.freeBase) return;
  for (const Restart& restart : trial.restarts)
    for (std::size_t k = restart.cycle;
         k < trial.cycles() && trial.time[k] < trial.time[restart.cycle] + settling; ++k)
      for (std::vector<double>& values : prediction.values)
        if (!values.empty()) values[k] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Prediction replay(const Plant& plant, const Trial& trial, const ReplayOptions& options) {
  Prediction result;
  const std::size_t cycles = trial.cycles();
  result.values.assign(trial.signals.size(), std::vector<double>());
  if (cycles < 2) return result;

  Playback playback(plant, trial, options);
  std::vector<std::size_t> body;  // signals of the whole robot, read at the cycle's time
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    if (trial.signals[s].joint < 0) body.push_back(s);
    if (trial.signals[s].joint < 0 || playback.reads(s))
      result.values[s].assign(cycles, std::numeric_limits<double>::quiet_NaN());
  }
  const auto keep = [&](const std::vector<Playback::Shown>& read) {
    for (const Playback::Shown& shown : read) result.values[shown.signal][shown.cycle] = shown.value;
  };
  keep(playback.settle());
  Stepper& stepper = playback.body();
  stepper.beginBody();
  auto restart = trial.restarts.begin();
  for (std::size_t k = 0; k < cycles; ++k) {
    if (options.restarts && restart != trial.restarts.end() && restart->cycle == k)
      stepper.restart(*restart++);
    if (!body.empty()) stepper.readBody(k, playback.time(), body, result.values);
    k = playback.lastInStep(k);
    keep(playback.playTo(k));
  }
  stepper.endBody(body, result.values);
  result.fell = stepper.fell();
  if (options.restarts) leaveSettlingOut(trial, result);
  return result;
}

}  // namespace plumbline::gap
