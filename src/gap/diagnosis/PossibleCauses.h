#pragma once
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Causes worth a look on these data: effects that the runs can show, at places that can have them, one per
/// place, variant and starting value (those of one place and variant beside each other). Where runs with a
/// held base show a joint or its chain to be clean, nothing there is tried, but see showsUnderLoad().
std::vector<Cause> possibleCauses(const Evaluator& evaluator);

/// Whether a cause at a joint or link of a leg is looked for in the runs on the feet: the held runs are
/// clean, those are not, and the weight on the leg may bring it out (a length, a mass, an offset, a weak
/// motor).
bool showsUnderLoad(const Evaluator& evaluator, const Cause& cause);

}  // namespace plumbline::gap
