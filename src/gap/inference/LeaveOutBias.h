#pragma once
#include <vector>

#include "gap/inference/LeaveOut.h"

namespace plumbline::gap {

/// By how much an answer from all groups closes more than what is found without one, in the logarithm of the
/// share that is left; below 0 where it closes more. A search without a group has fewer recordings, half as
/// many where there are two, and is a quicker one, so its answer carries over less well. It is
/// corrected as cross-validation with few folds is (Burman, "A comparative study of ordinary
/// cross-validation, v-fold cross-validation and the repeated learning-testing methods", Biometrika 76,
/// 1989). The loss is the logarithm: what the answer leaves in all groups, less what those without a group
/// leave in all groups, on average.
double leaveOutBias(const Groups& groups, const Explanation& answer,
                    const std::vector<FoundWithout>& without);

}  // namespace plumbline::gap
