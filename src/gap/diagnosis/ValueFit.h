#pragma once
#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// A cause with its value fitted, on top of an evaluator's base.
struct FittedCause {
  Cause cause;
  Fit fit;
  double screened = 0;  ///< gain on the blocks for fitting that screening promised
};

/// The cause with its strength multiplied, held within bounds.
Cause scaled(const Mechanism& mechanism, Cause cause, double share);

/// Limits of a search for a value: first step and tolerance in the logarithm of the strength, number of
/// values to find a bracket and then within it.
struct ValueSearch {
  double step = 0.5, tolerance = 0.004;
  int bracket = 8, within = 9;
};
/// Near enough to choose between causes.
inline constexpr ValueSearch roughly = {.step = 0.5, .tolerance = 0.02, .bracket = 8, .within = 6};

/// Fits the value of a cause on the evaluator's blocks for fitting, starting from its present value.
/// Thread-safe.
FittedCause fitValue(const Evaluator& evaluator, const Cause& start, const TrialMask& mask,
                     const ValueSearch& how = {});

/// Fits the values of causes that move the same joints together, starting from their present values. With a
/// fixed base it uses Gauss-Newton steps (GaussNewton.h). Causes at other joints do not interact and keep
/// their values, unless commands were lost, which affects all. With runs on the feet it uses CMA-ES (seeded).
Explanation fitTogether(const Evaluator& evaluator, const Explanation& causes, int jobs);
/// Repeats fitTogether() until the values converge, three times at most: steps that got stuck may continue.
Explanation fitSettled(const Evaluator& evaluator, Explanation causes, int jobs);

}  // namespace plumbline::gap
