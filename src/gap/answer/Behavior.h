#pragma once
#include <string>
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// One property of a run on the feet, measured and as two models replay it from the first command without
/// corrections (free run). NaN where a run does not show it.
struct Behavior {
  std::string name, unit;
  double measured = 0, nominal = 0, corrected = 0;
};

/// For every run with a free base: sway and tilt of the torso, load on the feet, whether it fell; path and
/// speed if an outside system measured them. nominal: predictions per trial; corrected: the evaluator's base.
std::vector<Behavior> behaviors(const Evaluator& evaluator, const std::vector<Prediction>& nominal);

}  // namespace plumbline::gap
