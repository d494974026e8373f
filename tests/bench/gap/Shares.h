#pragma once
#include "gap/diagnosis/Explanation.h"

namespace plumbline::bench {

/// The bound of a cause's value on one side of nominal.
double boundOf(const Mechanism& robot, const gap::Cause& cause, bool above);

/// The cause with its deviation set to a share of its bounds: -1 at the lower, 0 nominal, 1 at the upper. Of
/// a factor or a limit the deviation is its logarithm.
gap::Cause atShare(const Mechanism& robot, gap::Cause cause, double share);

}  // namespace plumbline::bench
