#pragma once
#include <cstdint>
#include <vector>

#include "gap/diagnosis/Evidence.h"
#include "gap/diagnosis/Explanation.h"

namespace plumbline::gap {

/// The cycles whose commands never came, found from the data of runs with a fixed base. A cycle counts as
/// lost if the readings after it fit better with the loss, by more than chance would give. share: of the
/// cycles in which a loss would have shown.
///
/// A lost command delays the joint by exactly one cycle, so the residual equals the change that the loss
/// causes. If something else looks like losses, this delay has any value. So no loss is found unless most of
/// the losses fit a delay of one cycle, nor if there are more losses than the effect allows.
struct LostCycles {
  std::vector<std::vector<std::uint8_t>> cycles;  ///< per trial; empty where not looked at
  double share = 0;
  /// Of a loss where nothing is known of the share, of the sum of squares: e^-7 by chance, in thousands of
  /// cycles.
  static constexpr double surePrice = 14;
  static constexpr std::size_t minCount = 3;  ///< cycles; fewer are chance
  std::size_t found = 0;
  /// In some recording a loss takes long to show, so that what losses near each other change overlaps.
  bool slow = false;
  /// Per trial: cycles in which a loss would have shown, and those of them that were lost.
  std::vector<std::size_t> seenIn, foundIn;
  double price = 0;  ///< of the sum of squares for judging: each cycle was chosen to fit
};
/// price: of each loss, of the sum of squares.
LostCycles findLostCycles(const Evidence& evidence, const Explanation& causes, int jobs,
                          double price = LostCycles::surePrice);

}  // namespace plumbline::gap
