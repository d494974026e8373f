#pragma once
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Causes to screen with these data: effects that the runs can show, at places that can have them, one per
/// place, variant and starting value (those of one place and variant are neighbours). If runs with a fixed
/// base show no gap at a joint or its chain, nothing is tried there; see UnderLoad for exceptions. Lost
/// commands are not included: they are decoded (LostCycles).
std::vector<Cause> possibleCauses(const Evaluator& evaluator);

/// Starting values by kind (effect, place and variant), without those that cause a limit cycle: an uncertain
/// prediction would excuse everything that it does not explain.
std::vector<std::vector<Cause>> byKind(const Mechanism& mechanism, const std::vector<Cause>& starts);

}  // namespace plumbline::gap
