#pragma once
#include <cstdint>
#include <vector>

#include "gap/replay/Plant.h"
#include "gap/replay/Trial.h"
#include "math/Random.h"

namespace plumbline::gap {

/// Per cycle, whether its command is lost, each with the probability of the plant's dropout; empty if none
/// is.
inline std::vector<std::uint8_t> drawLostCycles(const Plant& plant, const Trial& trial, Random random) {
  std::vector<std::uint8_t> lost;
  if (plant.dropout > 0)
    for (std::size_t k = 0; k < trial.cycles(); ++k) lost.push_back(random.uniform() < plant.dropout);
  return lost;
}

}  // namespace plumbline::gap
