#pragma once
#include <string>
#include <vector>

#include "gap/inference/HoldOut.h"

namespace plumbline::gap {

/// What a fit of all frictions in every joint closes beside the causes that were named. It says how much of
/// the gap a model could still take in, not where it comes from: so many values fit what others than friction
/// do.
struct Further {
  std::size_t parameters = 0;
  double closed = 0;  ///< of recordings left out: mean share that it closes more; negative: less
  std::vector<RecordingLeft> leftOut;

  /// "A further 12 % closes by fitting all frictions per joint (24 values); not attributable." Empty where it
  /// is not more than two in a hundred.
  std::string sentence() const;
};

/// Each group is left out in turn; the frictions are fitted to the others, beside the causes found without
/// it. foundElse: those, per group. leftOut: what they left. Only for robots whose base is held: empty
/// otherwise.
Further furtherOf(const Mechanism& robot, const std::vector<Trial>& trials,
                  const std::vector<Explanation>& foundElse, const std::vector<RecordingLeft>& leftOut,
                  int jobs);

}  // namespace plumbline::gap
