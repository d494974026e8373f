#pragma once
#include <vector>

#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Whether b repeats a: same motion, base and heading, and the same commands.
bool isRepeat(const Trial& a, const Trial& b);

/// Step of a quantised channel: the grid on which its readings lie in spite of noise (from the characteristic
/// function at the grid's frequency); 0 if there is none. Encoder counts per turn of 2^8 to 2^16 are tried.
double quantum(const std::vector<double>& values);

/// Standard deviation of a channel's own fast noise: from second differences, by the median, so that motion
/// does not count.
double fastNoise(const std::vector<double>& values);

/// How much one signal of one trial may differ without any cause.
struct SignalNoise {
  double sigma = 0;       ///< noise and quantisation, in the signal's unit
  double own = 0;         ///< the same from the channel itself alone
  bool repeated = false;  ///< found from repeats, else from the channel itself
};

enum class NoiseFrom { repeats, itself };

/// Noise per trial and signal. If there are repeats and they are to be used, it is their difference (median
/// over the pairs), else the channel's own fast noise. Both include half a count of the encoder.
std::vector<std::vector<SignalNoise>> estimateNoise(const std::vector<Trial>& trials,
                                                    NoiseFrom from = NoiseFrom::repeats);

/// Whether there are repeats with a fixed base, and each joint's position differs in them by hardly more than
/// its own fast noise. Then they contain nothing random.
bool repeatsAgree(const std::vector<Trial>& trials);

/// The noise of the residuals of predictions, from repeats: for recordings that differ by more than noise in
/// a way that can be predicted. Signals without a prediction count as they were read.
std::vector<std::vector<SignalNoise>> estimateNoiseOfResiduals(const std::vector<Prediction>& predictions,
                                                               const std::vector<Trial>& trials);

}  // namespace plumbline::gap
