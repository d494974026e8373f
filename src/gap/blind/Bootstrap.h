#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "math/Random.h"

namespace plumbline::gap {

/// Interval of 95 % of a statistic: percentile bootstrap (Efron 1979). The same sample gives the same
/// interval; it must not be empty.
template <class T, class Statistic>
std::pair<double, double> bootstrapInterval(const std::vector<T>& sample, Statistic&& statistic,
                                            std::size_t times) {
  Random random(1);
  std::vector<double> values;
  std::vector<T> again(sample.size());
  for (std::size_t i = 0; i < times; ++i) {
    for (T& x : again) x = sample[random.next() % sample.size()];
    values.push_back(statistic(again));
  }
  std::ranges::sort(values);
  return {values[times / 40], values[times - 1 - times / 40]};
}

}  // namespace plumbline::gap
