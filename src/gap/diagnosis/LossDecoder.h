#pragma once
#include <cstdint>
#include <vector>

#include "gap/diagnosis/Evidence.h"
#include "gap/replay/Plant.h"

namespace plumbline::gap {

/// The lost cycles that explain a recording with a held base best, each at a price in squares over noise:
/// guesses that differ in their last cycles are played side by side, and of those that agree in them the best
/// goes on (Viterbi's algorithm with per-survivor processing: Raheli, Polydoros and Tzou, "Per-survivor
/// processing", IEEE Trans. Communications 43, 1995; so many guesses survive a cycle as a third of the square
/// of told). told: cycles after which the readings have told whether one was lost; guesses agree or differ in
/// these. One flag per cycle; a loss that changes nothing is none.
std::vector<std::uint8_t> decodeLosses(const Plant& plant, const Evidence& evidence, std::size_t trial,
                                       double price, std::size_t detectionCycles);

}  // namespace plumbline::gap
