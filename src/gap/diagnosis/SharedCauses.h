#pragma once
#include <functional>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Causes common to all servos of one type, chosen together. If causes are added one at a time, the first
/// absorbs the effect of several, and a single unusual joint dominates. So pairs are tried first, and each
/// channel counts by the remaining share of its nominal squares, however large these are. nominal: an
/// evaluator without any cause. Returns two to maxCauses causes that act at all joints, values fitted
/// together. Returns none if no pair explains a fiftieth of the whole more than the best single cause.
Explanation sharedCauses(const Evaluator& nominal, std::size_t maxCauses, int jobs,
                         const std::function<void(double share)>& progress = {});

}  // namespace plumbline::gap
