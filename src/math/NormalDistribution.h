#pragma once
#include <cmath>

namespace plumbline {

/// The share of a normal distribution below `deviations` from its mean.
inline double shareBelow(double deviations) { return 0.5 * std::erfc(-deviations / std::sqrt(2.0)); }

}  // namespace plumbline
