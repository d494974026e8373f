#pragma once
#include "gap/diagnosis/ForwardSelection.h"
#include "gap/diagnosis/GapMeter.h"

namespace plumbline::gap {

/// Removes or replaces causes that make the gap on validation motions larger than `before`, the gap without
/// any cause. Each step takes out a cause or puts another of its candidates in its place, whichever predicts
/// best, until the gap is no larger. With a fixed base a force at a link and a shifted mass look alike; on
/// the feet one of them makes the robot fall. Sets the evaluator's base. Returns whether the set was changed.
bool pruneHarmful(ForwardSelection& selection, Evaluator& fine, const GapMeter& meter, double before,
                  int jobs);

}  // namespace plumbline::gap
