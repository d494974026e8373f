#pragma once
#include <vector>

#include "gap/inference/Score.h"

namespace plumbline::gap {

/// 95 % interval of each cause's value, in the logarithm of its strength. To each side it goes as far as the
/// profile of the log density takes it (a likelihood ratio, not its curvature at the fit), or what leaving
/// groups out makes of it (jackknife) if that is farther. To the square of that comes the variance of a bias:
/// what the model lacks is a function of the motion, as is what a cause changes, so that the two may be
/// correlated. The correlation in a channel is the same in all recordings, and normal about 0.
std::vector<Bounds> intervalsOf(const Replayer& replayer, const Scored& scored);

}  // namespace plumbline::gap
