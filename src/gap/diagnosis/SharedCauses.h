#pragma once
#include <functional>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// What servos of one type share, chosen together: of causes added one at a time the first takes what belongs
/// to several, and one joint that is odd in its own way draws all to itself. So pairs are tried first, and
/// each channel counts by the share of its nominal squares that is left, however large these are.
/// nominal: an evaluator without any cause. Returns two to maxCauses causes that act at all joints, values
/// fitted together, or none where no two explain more than the best alone by a fiftieth of the whole.
Explanation sharedCauses(const Evaluator& nominal, std::size_t maxCauses, int jobs,
                         const std::function<void(double share)>& progress = {});

}  // namespace plumbline::gap
