#pragma once
#include <vector>

#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Whether b is a recording of a's commands once more: same motion, base and heading, and the same commands.
bool isRepeat(const Trial& a, const Trial& b);

/// Step of a quantised channel, found as the grid its readings lie on in spite of noise (the characteristic
/// function at the grid's frequency); 0 where there is none. Encoder counts per turn of 2^8 to 2^16 are
/// tried.
double quantum(const std::vector<double>& values);

/// Standard deviation of a channel's own fast noise: from second differences, by the median, so that motion
/// does not count.
double fastNoise(const std::vector<double>& values);

/// What one signal of one trial may differ by without any cause.
struct SignalNoise {
  double sigma = 0;       ///< noise and quantisation, in the signal's unit
  double own = 0;         ///< the same from the channel itself alone
  bool repeated = false;  ///< found from repeats, else from the channel itself
};

enum class NoiseFrom { repeats, itself };

/// Per trial and signal: where a channel was recorded in repeats and they are to be used, what they differ by
/// (median over the pairs), else its own fast noise; half a count of the encoder is uncertain in both.
std::vector<std::vector<SignalNoise>> estimateNoise(const std::vector<Trial>& trials,
                                                    NoiseFrom from = NoiseFrom::repeats);

/// Whether repeats with a held base are there and differ, in each joint's position, by hardly more than its
/// own fast noise: nothing in them came by chance.
bool repeatsAgree(const std::vector<Trial>& trials);

/// The noise of what predictions leave, by repeats: for recordings that differ by more than noise, and by
/// what is predicted. Signals that are not predicted count as they were read.
std::vector<std::vector<SignalNoise>> estimateNoiseBeside(const std::vector<Prediction>& predictions,
                                                          const std::vector<Trial>& trials);

}  // namespace plumbline::gap
