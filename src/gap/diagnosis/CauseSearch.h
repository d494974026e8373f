#pragma once
#include <functional>
#include <vector>

#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

struct SearchOptions {
  int jobs = 1;
  std::size_t refine = 12;  ///< candidates whose value is fitted
  double leastGain = 0;     ///< of the sum of squares for fitting: what promises less is not fitted
  std::function<void(double)> progress = {};  ///< 0..1
};

/// Steps of the replays that a search looks with before it looks finely.
inline ReplayOptions coarseSteps() {
  ReplayOptions options;
  options.step = 0.005;
  options.gearStep = 0.00125;
  return options;
}

/// Every cause that could change what is seen, each effect at each place: one look at each (its change scaled
/// to fit best), then the value of the most promising ones fitted on the blocks for fitting, first roughly,
/// then finely where they come close to the best. Sorted by the sum of squares on the blocks for judging,
/// best first. causes: the list to try (see possibleCauses); coarse: an evaluator with the same base and
/// coarseSteps().
std::vector<Candidate> search(const Evaluator& evaluator, const Evaluator& coarse,
                              const std::vector<Cause>& causes, const SearchOptions& options);

}  // namespace plumbline::gap
