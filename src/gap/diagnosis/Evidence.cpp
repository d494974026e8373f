#include "gap/diagnosis/Evidence.h"

#include <algorithm>
#include <cmath>

namespace plumbline::gap {

namespace {

constexpr double blockSeconds = 0.5;
constexpr double startSeconds = 0.3;  // of a run: what came before it still rings
constexpr double timing = 1e-4;       // [s] commands and readings jitter at least so much
// Two engines' contacts differ by this much where nothing is wrong (measured on runs without any effect).
constexpr double freePosition = 4e-4, freeGyro = 0.01, freeAcceleration = 0.06, freeForce = 1.2;
// The same where a robot steps, of how far a signal swings.
constexpr double stepping = 0.05, steppingGyro = 0.12, steppingAcceleration = 0.2;

double engineSpread(const Trial& trial, const Signal& signal) {
  if (!trial.freeBase) return 0;
  switch (signal.kind) {
    case SignalKind::position:
      return freePosition;
    case SignalKind::gyro:
      return freeGyro;
    case SignalKind::accelerometer:
      return freeAcceleration;
    case SignalKind::force:
      return freeForce;
    default:
      return 0;
  }
}

double steppingShare(SignalKind kind) {
  return kind == SignalKind::gyro            ? steppingGyro
         : kind == SignalKind::accelerometer ? steppingAcceleration
                                             : stepping;
}

/// The difference between engines where a robot steps, in the signal's unit: a share of how far it swings; of
/// a joint, about its command.
double steppingSpread(const Trial& trial, const Signal& signal) {
  if (trial.restarts.empty()) return 0;
  double n = 0, sum = 0, squares = 0;
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    const double command =
        signal.kind == SignalKind::position ? trial.targets(static_cast<std::size_t>(signal.joint))[k] : 0;
    const double x = signal.values[k] - command;
    if (std::isfinite(x)) ++n, sum += x, squares += x * x;
  }
  const double swing = n > 1 ? std::sqrt(std::max(0.0, squares / n - sum / n * sum / n)) : 0;
  return steppingShare(signal.kind) * swing;
}

}  // namespace

bool Evidence::counts(const Signal& signal) {
  switch (signal.kind) {
    case SignalKind::position:
    case SignalKind::gyro:
    case SignalKind::accelerometer:
    case SignalKind::force:
      return true;
    default:
      return false;
  }
}

Evidence::Evidence(const std::vector<Trial>& trials, NoiseFrom from)
    : Evidence(trials, estimateNoise(trials, from)) {}

Evidence::Evidence(std::vector<Trial> trials, std::vector<std::vector<SignalNoise>> noises)
    : runs_(std::move(trials)), noises_(std::move(noises)) {
  for (std::size_t t = 0; t < runs_.size(); ++t) {
    const Trial& trial = runs_[t];
    auto& of = blockOf_.emplace_back();
    firstBlock_.push_back(blocks_);
    std::size_t last = 0;
    for (const double time : trial.time) {
      last = static_cast<std::size_t>((time - trial.time[0]) / blockSeconds);
      of.push_back(last);
    }
    blocks_ += last + 1 + (last % 2 == 0);  // each run begins with a block for fitting
    auto& perSignal = weight_.emplace_back();
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const Signal& signal = trial.signals[s];
      auto& w = perSignal.emplace_back(trial.cycles(), 0.0);
      if (!counts(signal)) continue;
      const double sigma = noises_[t][s].sigma,
                   spread = std::hypot(engineSpread(trial, signal), steppingSpread(trial, signal));
      for (std::size_t k = 0; k < trial.cycles(); ++k) {
        if (!std::isfinite(signal.values[k]) || trial.time[k] - trial.time[0] < startSeconds) continue;
        // The force of a landing differs between engines.
        if (signal.joint < 0 && !trial.betweenSteps.empty() && !trial.betweenSteps[k]) continue;
        const double rate = signal.kind == SignalKind::position ? rateAt(trial, signal, k) : 0;
        w[k] = 1 / (sigma * sigma + spread * spread + timing * timing * rate * rate);
      }
    }
  }
}

double Evidence::difference(std::size_t trial, const Prediction& a, const Prediction& b) const {
  double most = 0;
  for (std::size_t s = 0; s < a.values.size(); ++s) {
    const auto &x = a.values[s], &y = b.values[s];
    if (x.size() != y.size()) continue;
    double sum = 0, n = 0;
    forEach(trial, s, a, [&](std::size_t k, double w, double) {
      if (!std::isfinite(y[k])) return;
      sum += w * (x[k] - y[k]) * (x[k] - y[k]);
      ++n;
    });
    if (n > 0) most = std::max(most, std::sqrt(sum / n));
  }
  return most;
}

}  // namespace plumbline::gap
