#pragma once
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Causes worth a look on these data: effects that the runs can show, at places that can have them, one per
/// place, variant and starting value (those of one place and variant beside each other). Where runs with a
/// held base show a joint or its chain to be clean, nothing there is tried, but see UnderLoad. Lost commands
/// are no such cause: they are decoded (LostCycles).
std::vector<Cause> possibleCauses(const Evaluator& evaluator);

/// Starting values by kind (effect, place and variant), without those that bring a limit cycle: an
/// uncertain prediction would excuse whatever it does not explain.
std::vector<std::vector<Cause>> byKind(const Mechanism& mechanism, const std::vector<Cause>& starts);

}  // namespace plumbline::gap
