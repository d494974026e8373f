#pragma once
#include <functional>
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// A cause with its value fitted, on top of the evaluator's base.
struct Candidate {
  Cause cause;
  Fit fit;
  double screened = 0;  ///< gain on the blocks for fitting that the first look promised
};

struct SearchOptions {
  int jobs = 1;
  std::size_t refine = 12;                    ///< candidates whose value is fitted
  std::function<void(double)> progress = {};  ///< 0..1
};

/// Every cause that could change what is seen, each effect at each place: one look at each (its change scaled
/// to fit best), then the value of the most promising ones fitted on the blocks for fitting. Sorted by the
/// sum of squares on the blocks for judging, best first. causes: the list to try; coarse: an evaluator with
/// the same base and long steps, for the first look.
std::vector<Candidate> search(const Evaluator& evaluator, const Evaluator& coarse,
                              const std::vector<Cause>& causes, const SearchOptions& options);

/// Causes worth a look on these data: effects that the runs can show, at places that can have them, one per
/// place, variant and starting value. Where runs with a held base show a joint or its chain to be clean,
/// nothing there is tried.
std::vector<Cause> possibleCauses(const Evaluator& evaluator);

/// Value of a cause fitted by Brent's method on the distance from nominal, on a logarithmic scale.
Candidate fitValue(const Evaluator& evaluator, const Cause& start, const TrialMask& mask);

/// All values of an explanation fitted together by CMA-ES (seeded), from where they are.
Explanation fitTogether(const Evaluator& evaluator, const Explanation& causes, int evaluations, int jobs);

}  // namespace plumbline::gap
