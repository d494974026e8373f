#pragma once
#include <cstddef>

#include "gap/diagnosis/Evidence.h"
#include "gap/replay/Plant.h"

namespace plumbline::gap {

/// How many cycles a lost command's effect takes to show in a recording with a held base. A NAO's arm tells
/// within three, a servo that swings a heavy pendulum within twenty.
struct LossEcho {
  static constexpr std::size_t leastTold = 6, leastOver = 10, reach = 80;
  std::size_t told = leastTold;  ///< most losses have changed readings by twice the price by then
  std::size_t over = leastOver;  ///< little of what they change comes later
};

/// price: of a loss, in squares over noise. Losses that never change more than four times that say nothing;
/// where all are of that kind, the least there is.
LossEcho lossEcho(const Plant& plant, const Evidence& evidence, std::size_t trial, double price);

}  // namespace plumbline::gap
