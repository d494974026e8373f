#pragma once
#include "gap/blind/BlindCase.h"
#include "gap/diagnosis/Evaluator.h"

namespace plumbline::bench {

/// The one effect whose fit has the least Bayesian information criterion (Schwarz 1978) on all that the
/// diagnosis tries, nothing left out; empty where no effect has less than none. The evaluators' bases are
/// set.
gap::Explanation bestByBic(gap::Evaluator& fine, gap::Evaluator& coarse, int jobs);

/// Knows which effects there are; finds places and values, the first effect first.
gap::Explanation oracle(const gap::BlindCase& c, gap::Evaluator& fine, gap::Evaluator& coarse, int jobs);

}  // namespace plumbline::bench
