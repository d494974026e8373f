#pragma once
#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// A cause with its value fitted, on top of an evaluator's base.
struct Candidate {
  Cause cause;
  Fit fit;
  double screened = 0;  ///< gain on the blocks for fitting that the first look promised
};

/// The cause with its strength multiplied, held within bounds.
Cause scaled(const Mechanism& mechanism, Cause cause, double share);

/// How far a search for a value goes: first step and tolerance in the logarithm of the strength, values that
/// may be taken to find a bracket and then within it.
struct ValueSearch {
  double step = 0.5, tolerance = 0.004;
  int bracket = 8, within = 9;
};
/// Near enough to choose between causes.
inline constexpr ValueSearch roughly = {.step = 0.5, .tolerance = 0.02, .bracket = 8, .within = 6};

/// Value of a cause that fits best on the evaluator's blocks for fitting, from where it is. Thread-safe.
Candidate fitValue(const Evaluator& evaluator, const Cause& start, const TrialMask& mask,
                   const ValueSearch& how = {});

/// Values of causes that move the same joints fitted together, from where they are: with a held base by
/// Gauss-Newton steps (see GaussNewton.h), where the others do not feel each other and stay unless commands
/// were lost, which all feel; with runs on the feet by CMA-ES (seeded).
Explanation fitTogether(const Evaluator& evaluator, const Explanation& causes, int jobs);
/// fitTogether() begun anew until the values stay, three times at most: steps that stuck may go on.
Explanation fitSettled(const Evaluator& evaluator, Explanation causes, int jobs);

}  // namespace plumbline::gap
