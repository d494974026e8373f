#pragma once
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/diagnosis/GapMeter.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// What the i-th of the causes found is worth: interval, share of the gap alone and last, probability,
/// rivals. choices: what stood for choice in its place, most probable first; result: gap and known
/// probability of the whole. The evaluator's base is another afterwards.
Finding findingOf(std::size_t i, const Explanation& found, const std::vector<Candidate>& choices,
                  Evaluator& fine, const GapMeter& meter, const Diagnosis& result);

}  // namespace plumbline::gap
