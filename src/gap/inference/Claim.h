#pragma once
#include <vector>

#include "gap/inference/HoldOut.h"

namespace plumbline::gap {

/// What an answer closes of the gap in a recording of another motion: share, and its 90 % interval.
struct Claim {
  double closed = 0, lower = 0, upper = 0;
};

/// From what was closed in recordings left out, one value per group of them. Logarithms of the share that is
/// left are normal about a mean, with a spread from motion to motion. Both are unknown (random effects,
/// Gelman et al., Bayesian Data Analysis, chapter 5). The mean is 0 (nothing closed) give or take 1 before
/// any data, the spread half-normal of 0.5. Few groups are thus drawn to 0 and leave a wide interval; none
/// claim nothing.
///
/// bias: what is added to the logarithms because searches without a group have fewer recordings
/// (leaveOutBias).
Claim claimOf(const std::vector<double>& closedPerGroup, double bias = 0);

/// Logarithm of the share that is left; less than 2 % is noise.
double logLeft(double closed);

/// The mean of what was closed, above the floor, in the recordings of each group; groups that show no gap are
/// left out.
std::vector<double> closedPerGroup(const std::vector<RecordingLeft>& leftOut,
                                   const std::vector<std::size_t>& groupOfRecording);

}  // namespace plumbline::gap
