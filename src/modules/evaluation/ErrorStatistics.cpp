#include "modules/evaluation/ErrorStatistics.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

void ErrorStatistics::add(double error) {
  if (!std::isfinite(error)) return;
  largest_ = std::max(largest_, error);
  if (count_++ % stride_ != 0) return;
  if (samples_.size() == maxSamples) {
    for (std::size_t i = 0; i < maxSamples / 2; ++i) samples_[i] = samples_[2 * i];
    samples_.resize(maxSamples / 2);
    stride_ *= 2;
  }
  samples_.push_back(static_cast<float>(error));
}

double ErrorStatistics::quantile(double share) const {
  if (samples_.empty()) return 0;
  std::vector<float> sorted = samples_;
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(std::lround(place));
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

}  // namespace plumbline
