#pragma once
#include <string>

#include "gap/inference/Replayer.h"

namespace plumbline::gap {

/// What is left beyond the noise, over the noise, from which on the library lacks something. On the feet
/// engines differ in how soles touch and in what couples joints: with all causes found, up to 2.1 was left
/// there (doc/results/gap-diary.md, "First hung up, then on the feet").
inline constexpr double leastUnexplained = 1, leastUnexplainedOnFeet = 2.5;

/// The discrepancy's amplitude over the noise, in the signal where it is the largest share of what is no gap.
struct Worst {
  double size = 0;
  std::string signal;
  double mostExplained = leastUnexplained;

  double share() const { return size / mostExplained; }
};

/// Of each signal, hung up and on the feet apart: root of the mean over its cells.
Worst worstOf(const Replayer& replayer, const Explanation& causes);

}  // namespace plumbline::gap
