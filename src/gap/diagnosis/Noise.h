#pragma once
#include <vector>

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
  bool repeated = false;  ///< found from repeats, else from the channel itself
};

/// Per trial and signal. Repeats are used where there are any (median over the pairs of a channel), the
/// channel's fast noise otherwise; half a count of the encoder is uncertain in both.
std::vector<std::vector<SignalNoise>> estimateNoise(const std::vector<Trial>& trials);

}  // namespace plumbline::gap
