#pragma once
#include <cstddef>

#include "gap/diagnosis/Evidence.h"
#include "gap/replay/Plant.h"

namespace plumbline::gap {

/// How readings of a recording with a fixed base respond to one lost command, in cycles. A NAO's arm shows it
/// within three, a servo that swings a heavy pendulum within twenty.
struct LossResponse {
  static constexpr std::size_t minDetection = 6, minSettling = 10, reach = 80;
  std::size_t detectionCycles = minDetection;  ///< until most losses changed readings by twice the price
  std::size_t settlingCycles = minSettling;    ///< until most of their change is over
};

/// price: of a loss, in squares over noise. Losses that never change more than four times the price are not
/// counted; without any other the result is the minimum.
LossResponse lossResponse(const Plant& plant, const Evidence& evidence, std::size_t trial, double price);

}  // namespace plumbline::gap
