#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace plumbline {

/// Between which two values of a rising list another one lies: the first one's index and the weight of the
/// second, 0 to 1.
struct TablePlace {
  std::size_t first = 0;
  double second = 0;
};

/// For linear interpolation in a table over at least two rising values; beyond them: at the border.
inline TablePlace placeInTable(const std::vector<double>& values, double value) {
  const auto upper = std::upper_bound(values.begin() + 1, values.end() - 1, value);
  const auto i = static_cast<std::size_t>(upper - values.begin()) - 1;
  return {i, std::clamp((value - values[i]) / (values[i + 1] - values[i]), 0.0, 1.0)};
}

}  // namespace plumbline
