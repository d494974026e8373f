#include "gap/diagnosis/Noise.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <string>

#include "math/Median.h"

namespace plumbline::gap {

namespace {

constexpr double headingWithin = 0.01;   // [rad]
constexpr double commandWithin = 1e-3;   // [rad], root mean square
constexpr double sentWithin = 1e-3;      // of the root mean square of speeds or torques
constexpr double followedWithin = 0.01;  // [rad]: far more than encoders err, far less than a hand

double differenceOf(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  std::size_t n = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    const double d = a[k] - b[k];
    if (!std::isfinite(d)) continue;
    sum += d * d;
    ++n;
  }
  return n ? std::sqrt(sum / static_cast<double>(n)) : 0;
}

bool sameTimes(const Trial& a, const Trial& b) {
  const std::size_t n = std::min(a.cycles(), b.cycles());
  if (n * 10 < std::max(a.cycles(), b.cycles()) * 9) return false;
  for (std::size_t k = 0; k < n; ++k)
    if (std::abs((a.time[k] - a.time[0]) - (b.time[k] - b.time[0])) > 2e-3) return false;
  return true;
}

/// Whether commands are the same but for a share of their size, or neither trial has any. What a loop outside
/// of the servo sends follows the readings, so it differs from repeat to repeat.
bool sameSent(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
  for (std::size_t j = 0; j < std::max(a.size(), b.size()); ++j) {
    const bool inA = j < a.size() && !a[j].empty(), inB = j < b.size() && !b[j].empty();
    if (inA != inB) return false;
    if (inA && differenceOf(a[j], b[j]) > sentWithin * differenceOf(a[j], std::vector(a[j].size(), 0.0)))
      return false;
  }
  return true;
}

/// Estimates the noise from each trial's residuals, and the encoder's steps from the readings.
std::vector<std::vector<SignalNoise>> estimate(const std::vector<Trial>& trials,
                                               const std::vector<Trial>& left, NoiseFrom from) {
  // A channel has one noise for all runs of the same kind of base.
  struct Channel {
    std::vector<double> repeats, fast, steps;
  };
  std::map<std::pair<std::string, bool>, Channel> channels;
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const Signal& signal = trials[t].signals[s];
      Channel& channel = channels[{signal.name, trials[t].freeBase}];
      channel.fast.push_back(fastNoise(left[t].signals[s].values));
      if (signal.kind == SignalKind::position) channel.steps.push_back(quantum(signal.values));
    }
  for (std::size_t a = 0; a < trials.size(); ++a)
    for (std::size_t b = a + 1; b < trials.size(); ++b) {
      if (!isRepeat(trials[a], trials[b])) continue;
      for (const Signal& first : left[a].signals)
        for (const Signal& second : left[b].signals)
          if (first.name == second.name) {
            channels[{first.name, trials[a].freeBase}].repeats.push_back(
                differenceOf(first.values, second.values) / std::numbers::sqrt2);
          }
    }
  std::vector<std::vector<SignalNoise>> result;
  for (const Trial& trial : trials) {
    auto& noises = result.emplace_back();
    for (const Signal& signal : trial.signals) {
      const Channel& channel = channels[{signal.name, trial.freeBase}];
      SignalNoise noise;
      noise.repeated = !channel.repeats.empty();
      const double step = channel.steps.empty() ? 0 : *std::ranges::max_element(channel.steps);
      const double fast = upperMedian(channel.fast);
      const double own = noise.repeated && from == NoiseFrom::repeats ? upperMedian(channel.repeats) : fast;
      // Repeats of a still joint fall on the same count: half a count is unknown even so.
      noise.sigma = std::sqrt(own * own + step * step / 12);
      noise.own = std::sqrt(fast * fast + step * step / 12);
      double scale = 0;
      for (const double value : signal.values)
        if (std::isfinite(value)) scale = std::max(scale, std::abs(value));
      noise.sigma = std::max({noise.sigma, 1e-7 * scale, 1e-9});
      noise.own = std::max({noise.own, 1e-7 * scale, 1e-9});
      noises.push_back(noise);
    }
  }
  return result;
}

}  // namespace

bool isRepeat(const Trial& a, const Trial& b) {
  if (a.freeBase != b.freeBase ||
      std::abs(std::remainder(a.heading - b.heading, 2 * std::numbers::pi)) > headingWithin)
    return false;
  if (!sameTimes(a, b) || !sameSent(a.commandSpeed, b.commandSpeed) ||
      !sameSent(a.commandTorque, b.commandTorque))
    return false;
  for (std::size_t j = 0; j < a.command.size(); ++j)
    if (differenceOf(a.command[j], b.command[j]) > commandWithin ||
        differenceOf(a.targets(j), b.targets(j)) > followedWithin)
      return false;
  return true;
}

double quantum(const std::vector<double>& values) {
  constexpr std::size_t reach = 5;
  for (int bits = 8; bits <= 16; ++bits) {
    const double step = 2 * std::numbers::pi / std::exp2(bits);
    // Only readings on the move count: those of a joint that holds still agree with any grid.
    std::complex<double> sum = 0;
    std::size_t n = 0;
    for (std::size_t k = reach; k + reach < values.size(); ++k) {
      const double travel = std::abs(values[k + reach] - values[k - reach]);
      if (!std::isfinite(travel) || !std::isfinite(values[k]) || travel < 2 * step) continue;
      sum += std::polar(1.0, 2 * std::numbers::pi * values[k] / step);
      ++n;
    }
    if (n >= 100 && std::abs(sum) / static_cast<double>(n) > 0.25) return step;
  }
  return 0;
}

double fastNoise(const std::vector<double>& values) {
  std::vector<double> sizes;
  for (std::size_t k = 2; k < values.size(); ++k) {
    const double e = values[k] - 2 * values[k - 1] + values[k - 2];
    if (std::isfinite(e)) sizes.push_back(std::abs(e));
  }
  return sizes.size() < 10 ? 0 : 1.4826 * upperMedian(std::move(sizes)) / std::sqrt(6.0);
}

std::vector<std::vector<SignalNoise>> estimateNoise(const std::vector<Trial>& trials, NoiseFrom from) {
  return estimate(trials, trials, from);
}

bool repeatsAgree(const std::vector<Trial>& trials) {
  constexpr double hardlyMore = 1.25;
  bool any = false;
  const std::vector<std::vector<SignalNoise>> noises = estimateNoise(trials);
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const SignalNoise& noise = noises[t][s];
      if (trials[t].freeBase || trials[t].signals[s].kind != SignalKind::position || !noise.repeated)
        continue;
      if (noise.sigma > hardlyMore * noise.own) return false;
      any = true;
    }
  return any;
}

std::vector<std::vector<SignalNoise>> estimateNoiseOfResiduals(const std::vector<Prediction>& predictions,
                                                               const std::vector<Trial>& trials) {
  std::vector<Trial> left = trials;
  for (std::size_t t = 0; t < left.size(); ++t)
    for (std::size_t s = 0; s < predictions[t].values.size(); ++s)
      for (std::size_t k = 0; k < predictions[t].values[s].size(); ++k)
        left[t].signals[s].values[k] -= predictions[t].values[s][k];
  return estimate(trials, left, NoiseFrom::repeats);
}

}  // namespace plumbline::gap
