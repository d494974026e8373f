#pragma once
#include "gap/diagnosis/GapMeter.h"
#include "gap/diagnosis/Growth.h"

namespace plumbline::gap {

/// Where a set of causes makes the gap on held-out motions larger than `before`, which it is without any:
/// puts what stood for choice in a cause's place or takes a cause out, whichever predicts best, until it is
/// not. Hung up, a force at a link and a shifted mass look alike; on the feet one of them topples the robot.
/// Sets the evaluator's base; whether the set was changed.
bool leaveOutHarm(Growth& growth, Evaluator& fine, const GapMeter& meter, double before, int jobs);

}  // namespace plumbline::gap
