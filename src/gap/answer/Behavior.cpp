#include "gap/answer/Behavior.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace plumbline::gap {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double smoothing = 0.2;  // [s], of the tilt that an accelerometer shows
constexpr double fallen = 1;       // [rad]
constexpr double walked = 0.3;     // [m] from which a speed is worth a line

using SignalValues = std::vector<std::vector<double>>;  ///< per signal of the trial

const std::vector<double>* find(const Trial& trial, const SignalValues& series, SignalKind kind, int axis) {
  for (std::size_t s = 0; s < trial.signals.size(); ++s)
    if (trial.signals[s].kind == kind && trial.signals[s].axis == axis && !series[s].empty())
      return &series[s];
  return nullptr;
}

/// Root mean square of the turning rate about the level axes, their means taken off [rad/s].
double sway(const Trial& trial, const SignalValues& series) {
  double whole = 0;
  for (const int axis : {0, 1}) {
    const std::vector<double>* rate = find(trial, series, SignalKind::gyro, axis);
    if (!rate) return nan;
    double n = 0, sum = 0, squares = 0;
    for (const double w : *rate)
      if (std::isfinite(w)) ++n, sum += w, squares += w * w;
    if (n < 2) return nan;
    whole += std::max(0.0, squares / n - sum / n * sum / n);
  }
  return std::sqrt(whole);
}

/// Largest angle of the specific force, smoothed, from the torso's z axis [rad].
double largestTilt(const Trial& trial, const SignalValues& series) {
  const auto axis = [&](int i) { return find(trial, series, SignalKind::accelerometer, i); };
  const std::vector<double>*x = axis(0), *y = axis(1), *z = axis(2);
  if (!x || !y || !z) return nan;
  Vec3 smooth = Vec3::Zero();
  bool begun = false;
  double most = nan;
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    const Vec3 now((*x)[k], (*y)[k], (*z)[k]);
    if (!now.allFinite()) continue;
    const double h = k ? trial.time[k] - trial.time[k - 1] : 0;
    smooth = begun ? Vec3(smooth + std::min(1.0, h / smoothing) * (now - smooth)) : now;
    begun = true;
    const double tilt = std::atan2(smooth.head<2>().norm(), smooth.z());
    if (!(most >= tilt)) most = tilt;
  }
  return most;
}

/// Mean share of the first foot in what the force sensors carry.
double shareOnFirstFoot(const Trial& trial, const SignalValues& series) {
  double first = 0, all = 0;
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    if (trial.signals[s].kind != SignalKind::force) continue;
    for (const double f : series[s]) {
      if (!std::isfinite(f)) continue;
      all += f;
      if (trial.signals[s].place == 0) first += f;
    }
  }
  return all > 0 ? first / all : nan;
}

/// From the first to the last place seen, level [m].
double wayGone(const Trial& trial, const SignalValues& series) {
  const std::vector<double>*x = find(trial, series, SignalKind::truth, 0),
        *y = find(trial, series, SignalKind::truth, 1);
  if (!x || !y) return nan;
  const auto seen = [&](std::size_t k) { return std::isfinite((*x)[k]) && std::isfinite((*y)[k]); };
  std::size_t from = 0, to = x->size();
  while (from < x->size() && !seen(from)) ++from;
  while (to > from && !seen(to - 1)) --to;
  return to > from ? std::hypot((*x)[to - 1] - (*x)[from], (*y)[to - 1] - (*y)[from]) : nan;
}

/// What a robot does by itself: of one that steps, not from step to step.
Prediction inOnePiece(const Trial& trial, const Explanation& causes, const Prediction& known) {
  if (trial.restarts.empty()) return known;
  ReplayOptions options;
  options.restarts = false;
  return replay(plantOf(trial, causes), trial, options);
}

}  // namespace

std::vector<Behavior> behaviors(const Evaluator& evaluator, const std::vector<Prediction>& nominal) {
  std::vector<Behavior> list;
  const auto& trials = evaluator.evidence().trials();
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const Trial& trial = trials[t];
    if (!trial.freeBase) continue;
    const std::string run = std::filesystem::path(trial.name).filename().string();
    SignalValues measured;
    for (const Signal& signal : trial.signals) measured.push_back(signal.values);
    const Prediction plain = inOnePiece(trial, {}, nominal[t]),
                     better = inOnePiece(trial, evaluator.base(), evaluator.basePrediction(t));
    const auto add = [&](const std::string& what, const std::string& unit, auto&& of) {
      const double seen = of(trial, measured);
      if (std::isfinite(seen))
        list.push_back({what + ", " + run, unit, seen, of(trial, plain.values), of(trial, better.values)});
    };
    add("sway (RMS turning rate)", "rad/s", sway);
    add("largest tilt", "rad", largestTilt);
    if (!evaluator.mechanism().feet.empty())
      add("weight on " + evaluator.mechanism().feet[0].name, "1", shareOnFirstFoot);
    add("way gone", "m", wayGone);
    if (const double seconds = trial.time.back() - trial.time.front(); wayGone(trial, measured) > walked)
      add("mean speed", "m/s",
          [&](const Trial& of, const SignalValues& series) { return wayGone(of, series) / seconds; });
    const double tilt = largestTilt(trial, measured);
    if (std::isfinite(tilt))
      list.push_back({"fell, " + run, "0 or 1", tilt > fallen ? 1.0 : 0.0, plain.fell ? 1.0 : 0.0,
                      better.fell ? 1.0 : 0.0});
  }
  return list;
}

}  // namespace plumbline::gap
