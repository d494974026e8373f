#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace plumbline {

/// The middle value, of an even number the larger of the two in the middle; `ofNone` without values. Unlike
/// the mean of these two it is one of the values, so it keeps a grid that they are on. No value may be NaN.
inline double upperMedian(std::vector<double> values, double ofNone = 0) {
  if (values.empty()) return ofNone;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace plumbline
