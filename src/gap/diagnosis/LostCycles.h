#pragma once
#include <cstdint>
#include <vector>

#include "gap/diagnosis/Evidence.h"
#include "gap/diagnosis/Explanation.h"

namespace plumbline::gap {

/// Which cycles' commands never came, found from the data of runs with a held base: a cycle counts as lost
/// where the readings after it fit better so, by more than chance would give. share: of the cycles in which a
/// loss would have shown.
///
/// A command that was lost leaves the joint a whole cycle late, no more and no less: what its readings are
/// off by is once what the loss changes. Where something else is told as losses, that lateness lies anywhere;
/// unless most of the losses are of one cycle, none is found at all, nor where there are more than the effect
/// can be.
struct LostCycles {
  std::vector<std::vector<std::uint8_t>> cycles;  ///< per trial; empty where not looked at
  double share = 0;
  static constexpr std::size_t least = 3;  ///< fewer are chance
  std::size_t found = 0;
  double price = 0;  ///< of the sum of squares for judging: each cycle was chosen to fit
};
LostCycles findLostCycles(const Evidence& evidence, const Explanation& causes, int jobs);

}  // namespace plumbline::gap
