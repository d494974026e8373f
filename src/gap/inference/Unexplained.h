#pragma once
#include <string>

#include "gap/inference/Replayer.h"

namespace plumbline::gap {

/// What is left beyond the noise, over the noise, from which on the library lacks something. On the feet
/// engines differ in how soles touch and in what couples joints: with all causes found up to 3.2 was left
/// there (doc/results/gap-diary.md, "First hung up, then on the feet").
inline constexpr double leastUnexplained = 1, leastUnexplainedOnFeet = 4;
/// The same from which on causes are looked for on the feet: where nothing more was missing up to 1.6 was
/// left.
inline constexpr double leastSearchedOnFeet = 2;

/// The discrepancy's amplitude over the noise, in the signal where it is the largest share of its bound.
struct Worst {
  double size = 0;
  std::string signal;
  double bound = leastUnexplained;  ///< up to which it is no gap

  double share() const { return size / bound; }
};

/// Of each signal, hung up and on the feet apart: root of the mean over its cells. onFeet: the bound
/// there.
Worst worstOf(const Replayer& replayer, const Explanation& causes, double onFeet = leastUnexplainedOnFeet);

}  // namespace plumbline::gap
