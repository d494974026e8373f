#pragma once
#include <vector>

#include "gap/inference/LeaveOut.h"

namespace plumbline::gap {

/// By how much an answer from all groups closes more than what is found without one, in the logarithm of the
/// share that is left; below 0 where it closes more. A search without a group has fewer recordings, half as
/// many where there are two, and its answer carries over less well. Burman's correction of cross-validation
/// for few folds (Biometrika 76, 1989, eq. 2.3): what the answer leaves in all groups, less what those
/// without a group leave in all groups, on average.
double leaveOutBias(const Groups& groups, const Explanation& answer,
                    const std::vector<FoundWithout>& without);

}  // namespace plumbline::gap
