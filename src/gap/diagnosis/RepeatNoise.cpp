#include "gap/diagnosis/RepeatNoise.h"

#include <algorithm>
#include <cmath>

#include "gap/diagnosis/LostCycles.h"

namespace plumbline::gap {

namespace {

constexpr double minNoiseRatio = 1.5;      // times another noise
constexpr double minExplainedShare = 0.5;  // of the squares of what they differ by
constexpr int rounds = 2;  // losses jerk at a channel's own noise: it is lower once they are known

/// Whether what was taken for noise is clearly more than in another evidence of the same runs, in half of the
/// joints that were repeated with the base fixed.
bool isNoisier(const Evidence& byRepeats, const Evidence& other) {
  std::size_t joints = 0, differ = 0;
  for (std::size_t t = 0; t < byRepeats.trials().size(); ++t) {
    const Trial& trial = byRepeats.trials()[t];
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const SignalNoise& noise = byRepeats.noise(t, s);
      if (trial.freeBase || trial.signals[s].kind != SignalKind::position || !noise.repeated) continue;
      ++joints;
      differ += noise.sigma > minNoiseRatio * other.noise(t, s).sigma;
    }
  }
  return differ * 2 > joints;
}

/// The motion of the robot with these causes where commands get lost, NaN where a sample does not count; runs
/// on the feet are not predicted.
std::vector<Prediction> predictionsWith(const LostCycles& lost, const Explanation& causes,
                                        const Evidence& evidence) {
  const auto& trials = evidence.trials();
  std::vector<Prediction> predictions(trials.size());
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].freeBase) continue;
    ReplayOptions options;
    options.lostCycles = &lost.cycles[t];
    predictions[t] = replay(plantOf(trials[t], causes), trials[t], options);
    for (std::size_t s = 0; s < predictions[t].values.size(); ++s)
      for (std::size_t k = 0; k < predictions[t].values[s].size(); ++k)
        if (!(evidence.weights(t, s)[k] > 0)) predictions[t].values[s][k] = std::nan("");
  }
  return predictions;
}

/// Share of the squares of what repeats differ by (beyond noise) that is predicted.
double explainedBy(const std::vector<Prediction>& predictions, const Evidence& evidence) {
  const auto& trials = evidence.trials();
  double before = 0, after = 0, n = 0;
  for (std::size_t a = 0; a < trials.size(); ++a)
    for (std::size_t b = a + 1; b < trials.size(); ++b) {
      if (trials[a].freeBase || !isRepeat(trials[a], trials[b])) continue;
      for (std::size_t s = 0; s < std::min(trials[a].signals.size(), trials[b].signals.size()); ++s) {
        const Signal &one = trials[a].signals[s], &two = trials[b].signals[s];
        const auto &x = predictions[a].values[s], &y = predictions[b].values[s];
        if (one.name != two.name || one.kind != SignalKind::position) continue;
        for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k) {
          const double w = evidence.weights(a, s)[k] / 2, d = one.values[k] - two.values[k], e = x[k] - y[k];
          if (!(w > 0) || !std::isfinite(d) || !std::isfinite(e)) continue;
          before += w * d * d;
          after += w * (d - e) * (d - e);
          ++n;
        }
      }
    }
  return before > n ? (before - after) / (before - n) : 0;
}

}  // namespace

std::optional<Evidence> evidenceWithoutLosses(const Evidence& byRepeats, const Explanation& causes,
                                              int jobs) {
  const std::vector<Trial>& trials = byRepeats.trials();
  Evidence evidence(trials, NoiseFrom::itself);
  if (!isNoisier(byRepeats, evidence)) return {};
  for (int round = 0; round < rounds; ++round) {
    const LostCycles lost = findLostCycles(evidence, causes, jobs);
    const std::vector<Prediction> predictions = predictionsWith(lost, causes, evidence);
    if (round == 0 &&
        (lost.found < LostCycles::minCount || explainedBy(predictions, evidence) <= minExplainedShare))
      return {};
    evidence = Evidence(trials, estimateNoiseOfResiduals(predictions, trials));
  }
  if (!isNoisier(byRepeats, evidence)) return {};
  return evidence;
}

Evidence evidenceOf(std::vector<Trial> trials, int jobs) {
  Evidence byRepeats(std::move(trials));
  std::optional<Evidence> withoutLosses = evidenceWithoutLosses(byRepeats, {}, jobs);
  return withoutLosses ? *std::move(withoutLosses) : byRepeats;
}

}  // namespace plumbline::gap
