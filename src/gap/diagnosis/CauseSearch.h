#pragma once
#include <functional>
#include <vector>

#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

struct SearchOptions {
  int jobs = 1;
  std::size_t refine = 12;  ///< candidates whose value is fitted
  double leastGain = 0;     ///< of the sum of squares for fitting: causes that promise less are not fitted
  std::function<void(double)> progress = {};  ///< 0..1
};

/// Longer time steps of the replays for screening.
inline ReplayOptions coarseSteps() {
  ReplayOptions options;
  options.step = 0.005;
  options.gearStep = 0.00125;
  return options;
}

/// Screens every effect at every place where it could change the readings: one replay each, its change scaled
/// to fit best. Then the values of the most promising causes are fitted on the blocks for fitting, first
/// roughly, then finely if they are close to the best. Sorted by the sum of squares on the blocks for
/// judging, best first. causes: the list to try (see possibleCauses); coarse: an evaluator with the same base
/// and coarseSteps().
std::vector<FittedCause> search(const Evaluator& evaluator, const Evaluator& coarse,
                                const std::vector<Cause>& causes, const SearchOptions& options);

}  // namespace plumbline::gap
