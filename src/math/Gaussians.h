#pragma once
#include <cmath>
#include <span>

#include "math/Random.h"

namespace plumbline {

/// Fills with numbers of mean 0 and deviation 1, both that Marsaglia's polar method makes at a time: other
/// ones than Random::gaussian(), which throws the second one away, with half the draws.
inline void fillGaussian(Random& random, std::span<double> all) {
  for (std::size_t i = 0; i < all.size();) {
    const double u = random.uniform(-1, 1), v = random.uniform(-1, 1), s = u * u + v * v;
    if (!(s > 0 && s < 1)) continue;
    const double length = std::sqrt(-2 * std::log(s) / s);
    all[i++] = u * length;
    if (i < all.size()) all[i++] = v * length;
  }
}

}  // namespace plumbline
