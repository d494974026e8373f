#pragma once
#include <vector>

#include "gap/inference/Score.h"

namespace plumbline::gap {

/// 95 % interval of each cause's value, in the logarithm of its strength. To each side it goes as far as the
/// profile of the log density takes it (a likelihood ratio, not its curvature at the fit). It goes as far as
/// leaving groups out does (jackknife) if that is farther. The variance of a bias is added to the square of
/// that. What the model lacks is a function of the motion, and so is what a cause changes: the two may be
/// correlated. The correlation in a channel is the same in all recordings, and normal about 0.
std::vector<Bounds> intervalsOf(const Replayer& replayer, const Scored& scored);

}  // namespace plumbline::gap
