#pragma once
#include <string>
#include <vector>

#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Step of a quantised channel: the smallest difference between readings that occurs, if nearly all others
/// are multiples of it; 0 where there is none.
double smallestStep(std::vector<double> values);

/// What a channel is worth as evidence.
struct ChannelUse {
  bool used = false;
  double noise = 0;         ///< standard deviation of readings about what a perfect model predicts [its unit]
  double readingNoise = 0;  ///< the same without what repeats differ by beyond it [its unit]
  std::string why;          ///< why it is not used
};

/// Per trial and signal. Noise is what repeats differ by, where there are some, else the channel's fast part
/// (second differences); with it go the rounding of a quantised channel and 0.1 ms of jitter. One value per
/// channel and kind of base, over all recordings. predicted: per trial, what a model predicts (empty: of
/// none). What repeats differ by is then what it leaves, and so is the fast part, where that is less.
std::vector<std::vector<ChannelUse>> channelUses(const std::vector<Trial>& trials,
                                                 const std::vector<Prediction>& predicted = {});

}  // namespace plumbline::gap
