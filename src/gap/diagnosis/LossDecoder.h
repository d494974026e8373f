#pragma once
#include <cstdint>
#include <vector>

#include "gap/diagnosis/Evidence.h"
#include "gap/replay/Plant.h"

namespace plumbline::gap {

/// The lost cycles that explain a recording with a fixed base best; each loss has a price in squares over
/// noise. Hypotheses that differ in their last cycles are replayed in parallel, and of those that agree in
/// them only the best continues. This is Viterbi's algorithm with per-survivor processing (Raheli, Polydoros
/// and Tzou, "Per-survivor processing", IEEE Trans. Communications 43, 1995). A third of
/// detectionCycles squared survive a cycle, at most 512, and none that is more than the price of four losses
/// behind the best, times the mean square over noise that the best leaves. detectionCycles: until the
/// readings show a loss; hypotheses are compared in these. Returns one flag per cycle; a loss that changes
/// nothing does not count.
std::vector<std::uint8_t> decodeLosses(const Plant& plant, const Evidence& evidence, std::size_t trial,
                                       double price, std::size_t detectionCycles);

}  // namespace plumbline::gap
