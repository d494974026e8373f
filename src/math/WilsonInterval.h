#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline {

/// 95 % interval of a rate of which `found` of `count` were counted (Wilson, "Probable inference, the law of
/// succession, and statistical inference", J. American Statistical Association 22, 1927); 0 to 1 of none.
inline std::pair<double, double> wilsonInterval(double found, double count) {
  if (!(count > 0)) return {0, 1};
  constexpr double z = 1.959964;
  const double p = found / count, middle = (p + z * z / (2 * count)) / (1 + z * z / count),
               half = z / (1 + z * z / count) * std::sqrt(p * (1 - p) / count + z * z / (4 * count * count));
  return {found <= 0 ? 0 : std::max(0.0, middle - half), found >= count ? 1 : std::min(1.0, middle + half)};
}

}  // namespace plumbline
