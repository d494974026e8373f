#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "gap/diagnosis/Noise.h"
#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Runs with the weight of each sample, divided into blocks of about half a second. Every other block is for
/// fitting, the rest for judging.
class Evidence {
public:
  explicit Evidence(const std::vector<Trial>& trials, NoiseFrom from = NoiseFrom::repeats);
  /// With another noise, per trial and signal.
  Evidence(std::vector<Trial> trials, std::vector<std::vector<SignalNoise>> noises);

  /// The same with every channel's weights multiplied: factor(trial, signal).
  template <class Factor>
  Evidence weightedBy(Factor&& factor) const {
    Evidence other = *this;
    for (std::size_t t = 0; t < runs_.size(); ++t)
      for (std::size_t s = 0; s < weight_[t].size(); ++s)
        for (double& w : other.weight_[t][s]) w *= factor(t, s);
    return other;
  }

  const std::vector<Trial>& trials() const { return runs_; }
  /// 1 / variance per sample; 0 where a sample does not count (lost, start of a run, not predicted).
  const std::vector<double>& weights(std::size_t trial, std::size_t signal) const {
    return weight_[trial][signal];
  }
  const SignalNoise& noise(std::size_t trial, std::size_t signal) const { return noises_[trial][signal]; }

  std::size_t numBlocks() const { return blocks_; }
  std::size_t block(std::size_t trial, std::size_t cycle) const {
    return firstBlock_[trial] + blockOf_[trial][cycle];
  }
  static bool forFitting(std::size_t block) { return block % 2 == 0; }
  /// Calls use(cycle, weight, residual) for every sample of a channel that counts and was predicted; the
  /// weight is smaller if the prediction is uncertain.
  template <class Use>
  void forEach(std::size_t trial, std::size_t signal, const Prediction& prediction, Use&& use) const {
    const auto& w = weight_[trial][signal];
    const auto& predicted = prediction.values[signal];
    const auto& measured = runs_[trial].signals[signal].values;
    for (std::size_t k = 0; k < predicted.size(); ++k)
      if (w[k] > 0 && std::isfinite(predicted[k]))
        use(k, w[k] * certainty(prediction, signal, k, w[k]), measured[k] - predicted[k]);
  }
  /// Noise variance divided by the sum of noise variance and variance of a prediction, for a sample of this
  /// weight; 1 if nothing is uncertain.
  static double certainty(const Prediction& prediction, std::size_t signal, std::size_t cycle,
                          double weight) {
    if (prediction.variance.empty() || prediction.variance[signal].empty()) return 1;
    return 1 / (1 + weight * prediction.variance[signal][cycle]);
  }
  /// Largest difference of two predictions of a trial over all channels: root mean square divided by the
  /// channel's noise.
  double difference(std::size_t trial, const Prediction& a, const Prediction& b) const;
  /// Whether a channel of this kind takes part: positions, inertial sensors, force sensors.
  static bool counts(const Signal& signal);

private:
  std::vector<Trial> runs_;
  std::vector<std::vector<SignalNoise>> noises_;
  std::vector<std::vector<std::vector<double>>> weight_;
  std::vector<std::vector<std::size_t>> blockOf_;
  std::vector<std::size_t> firstBlock_;
  std::size_t blocks_ = 0;
};

}  // namespace plumbline::gap
