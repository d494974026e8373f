#include "gap/inference/Channels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "gap/diagnosis/Noise.h"
#include "gap/diagnosis/UnusedColumns.h"
#include "math/Median.h"

namespace plumbline::gap {

namespace {

constexpr double jitter = 1e-4;      // [s] of commands and readings
constexpr double onTheGrid = 0.9;    // share of differences that must be multiples of a step
constexpr double offTheGrid = 0.1;   // of a step, that a multiple may be off by rounding in a file
constexpr double leastShare = 1e-7;  // of a channel's range: numbers in a file have no more digits

/// The fast part of a signal, as a standard deviation: differences of order 2 to 4, whichever is least. Each
/// is white noise's own if there is no motion; motion adds to it, to a higher order less if it is smooth, to
/// a lower one less if it jumps.
double fastPart(const std::vector<double>& values) {
  constexpr double normal = 1.4826;                    // standard deviation over median of absolute values
  constexpr std::array<double, 3> squares{6, 20, 70};  // of the binomial coefficients of an order
  std::vector<double> e;
  for (std::size_t k = 1; k < values.size(); ++k) e.push_back(values[k] - values[k - 1]);
  double least = HUGE_VAL;
  for (const double square : squares) {
    for (std::size_t k = e.size(); k-- > 1;) e[k] -= e[k - 1];
    if (!e.empty()) e.erase(e.begin());
    std::vector<double> sizes;
    for (const double x : e)
      if (std::isfinite(x)) sizes.push_back(std::abs(x));
    if (sizes.size() < 10) return 0;
    least = std::min(least, normal * upperMedian(std::move(sizes)) / std::sqrt(square));
  }
  return least;
}

double rmsRate(const Trial& trial, const Signal& signal) {
  double sum = 0, n = 0;
  for (std::size_t k = 1; k + 1 < trial.cycles(); ++k) {
    const double rate = rateAt(trial, signal, k);
    sum += rate * rate;
    ++n;
  }
  return n > 0 ? std::sqrt(sum / n) : 0;
}

double differenceOf(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0, n = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    const double d = a[k] - b[k];
    if (!std::isfinite(d)) continue;
    sum += d * d;
    ++n;
  }
  return n > 0 ? std::sqrt(sum / n / 2) : 0;
}

/// Per trial and signal: readings less what is predicted of them, if it is.
std::vector<std::vector<std::vector<double>>> unpredicted(const std::vector<Trial>& trials,
                                                          const std::vector<Prediction>& predicted) {
  std::vector<std::vector<std::vector<double>>> left;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    auto& of = left.emplace_back();
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      std::vector<double>& values = of.emplace_back(trials[t].signals[s].values);
      if (predicted.empty() || predicted[t].values.empty() || predicted[t].values[s].empty()) continue;
      for (std::size_t k = 0; k < values.size(); ++k) values[k] -= predicted[t].values[s][k];
    }
  }
  return left;
}

/// What is known of a channel over all recordings.
struct Found {
  std::vector<double> repeats, fast, steps, rates;
  double largest = 0;
  SignalKind kind = SignalKind::position;
  double step = 0;  ///< of its readings' grid; 0: there is none
};

/// Per channel, by name and kind of base.
using Channels = std::map<std::pair<std::string, bool>, Found>;

/// A channel that hardly moves does not show its grid, so a perfect model would seem more exact than the
/// readings are. It gets the grid of the channels of its kind.
void findSteps(Channels& channels) {
  std::map<std::pair<SignalKind, bool>, std::vector<double>> ofKind;
  for (auto& [name, found] : channels) {
    found.step = upperMedian(found.steps);
    if (found.step > 0) ofKind[{found.kind, name.second}].push_back(found.step);
  }
  for (auto& [name, found] : channels)
    if (found.steps.empty())
      if (const double step = upperMedian(ofKind[{found.kind, name.second}]); upperMedian(found.fast) < step)
        found.step = step;
}

/// Root mean square of the duty (share of the supply, 0..1) of a motor at rest that draws this current from
/// its supply.
double rmsDuty(const Signal& supplyCurrent, const Servo& servo) {
  double sum = 0, n = 0;
  for (const double value : supplyCurrent.values)
    if (std::isfinite(value)) sum += std::abs(value), ++n;
  return n > 0 && servo.vin > 0 ? std::sqrt(sum / n * servo.R / servo.vin) : 0;
}

/// Noise of a predicted duty, torque [N m] or current [A] that comes from the noise of the measured angle.
double effortOfAngle(const Trial& trial, const Signal& effort, const Channels& channels) {
  const Signal* const position = positionOf(trial, effort.joint);
  if (!position) return 0;
  const Servo& servo = trial.robot->joints[static_cast<std::size_t>(effort.joint)].servo;
  const Found& found = channels.at({position->name, trial.freeBase});
  const double rounded = found.step / std::sqrt(12.0);
  if (effort.kind == SignalKind::duty) return servo.kpFirmware * servo.errorGain * rounded;
  const double angle = std::hypot(rounded, upperMedian(found.fast));
  const double cycle = (trial.time.back() - trial.time.front()) / static_cast<double>(trial.cycles() - 1);
  // The speed is a central difference.
  const double torque = angle * std::hypot(servo.kp, servo.kd / (std::numbers::sqrt2 * cycle));
  if (effort.kind == SignalKind::torque) return torque;
  // The supply's current is the duty times the motor's, and so grows with its square.
  return torque / servo.kt * (effort.ofSupply ? 2 * rmsDuty(effort, servo) : 1);
}

std::string whyNot(const Trial& trial, const Signal& signal) {
  switch (signal.kind) {
    case SignalKind::duty: {
      const auto joint = static_cast<std::size_t>(signal.joint);
      if (trial.robot->joints[joint].servo.model != Servo::Model::dcMotor)
        return "the robot's file gives no law of the servo's duty";
      if (trial.robot->joints[joint].servo.followsTorque) return "the motor was sent no positions";
      return "";
    }
    case SignalKind::current: {
      const auto joint = static_cast<std::size_t>(signal.joint);
      if (!(trial.robot->joints[joint].servo.kt > 0)) return "the robot's file gives no torque per ampere";
      return "";
    }
    default:
      return whyNeverUsed(signal.kind);
  }
}

}  // namespace

double smallestStep(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  std::ranges::sort(values);
  if (values.size() < 20) return 0;
  const double least = leastShare * std::max(std::abs(values.front()), std::abs(values.back()));
  std::vector<double> steps;
  for (std::size_t k = 1; k < values.size(); ++k)
    if (values[k] - values[k - 1] > std::max(least, 1e-12)) steps.push_back(values[k] - values[k - 1]);
  if (steps.size() < 5) return 0;
  const double most = values.back() - values.front();
  // Rounding to so many digits spreads one step over a few values: their median is the step.
  const double smallest = *std::ranges::min_element(steps);
  std::vector<double> alike;
  for (const double step : steps)
    if (step < 1.5 * smallest) alike.push_back(step);
  const double step = upperMedian(alike);
  // With as many steps as readings there is no grid.
  if (most / step > 4 * static_cast<double>(values.size())) return 0;
  std::size_t multiples = 0;
  for (const double other : steps)
    if (std::abs(std::remainder(other, step)) < offTheGrid * step) ++multiples;
  return static_cast<double>(multiples) >= onTheGrid * static_cast<double>(steps.size()) ? step : 0;
}

std::vector<std::vector<ChannelUse>> channelUses(const std::vector<Trial>& trials,
                                                 const std::vector<Prediction>& predicted) {
  const std::vector<std::vector<std::vector<double>>> left = unpredicted(trials, predicted);
  Channels channels;
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const Trial& trial = trials[t];
      const Signal& signal = trial.signals[s];
      Found& found = channels[{signal.name, trial.freeBase}];
      found.kind = signal.kind;
      found.fast.push_back(fastPart(signal.values));
      if (const double fast = predicted.empty() ? 0 : fastPart(left[t][s]); fast > 0)
        found.fast.back() = std::min(found.fast.back(), fast);
      if (const double step = smallestStep(signal.values); step > 0) found.steps.push_back(step);
      found.rates.push_back(rmsRate(trial, signal));
      for (const double value : signal.values)
        if (std::isfinite(value)) found.largest = std::max(found.largest, std::abs(value));
    }
  for (std::size_t a = 0; a < trials.size(); ++a)
    for (std::size_t b = a + 1; b < trials.size(); ++b) {
      if (!isRepeat(trials[a], trials[b])) continue;
      for (std::size_t s = 0; s < trials[a].signals.size(); ++s)
        for (std::size_t other = 0; other < trials[b].signals.size(); ++other)
          if (const std::string& name = trials[a].signals[s].name; name == trials[b].signals[other].name)
            channels[{name, trials[a].freeBase}].repeats.push_back(differenceOf(left[a][s], left[b][other]));
    }
  findSteps(channels);
  std::vector<std::vector<ChannelUse>> uses;
  for (const Trial& trial : trials) {
    auto& of = uses.emplace_back();
    for (const Signal& signal : trial.signals) {
      const Found& found = channels[{signal.name, trial.freeBase}];
      ChannelUse use;
      use.why = whyNot(trial, signal);
      use.used = use.why.empty();
      const bool effort = isEffort(signal.kind);
      const bool moves = signal.kind == SignalKind::position || effort;
      const double late = moves ? jitter * upperMedian(found.rates) : 0;
      const double angle = effort && use.used ? effortOfAngle(trial, signal, channels) : 0;
      const auto noiseWith = [&](double own) {
        const double all = std::sqrt(own * own + found.step * found.step / 12 + late * late + angle * angle);
        return std::max({all, leastShare * found.largest, 1e-9});
      };
      use.readingNoise = noiseWith(upperMedian(found.fast));
      use.noise = std::max(use.readingNoise, noiseWith(upperMedian(found.repeats)));
      of.push_back(std::move(use));
    }
  }
  return uses;
}

}  // namespace plumbline::gap
