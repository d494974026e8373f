#pragma once
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/diagnosis/GapMeter.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// Assesses the i-th cause found: interval, share of the gap alone and last, probability, rivals. choices:
/// the alternatives for it, most probable first; result: gap and known probability of the whole. Changes the
/// evaluator's base.
Finding findingOf(std::size_t i, const Explanation& found, const std::vector<FittedCause>& choices,
                  Evaluator& fine, const GapMeter& meter, const Diagnosis& result);

}  // namespace plumbline::gap
