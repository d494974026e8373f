#pragma once
#include <cstddef>
#include <vector>

namespace plumbline {

/// Quantiles of many errors in bounded memory: beyond maxSamples every second one kept is dropped, and from
/// then on every second one that comes, and so on.
class ErrorStatistics {
public:
  static constexpr std::size_t maxSamples = 1u << 17;

  ErrorStatistics() { samples_.reserve(maxSamples); }

  void add(double error);
  std::size_t count() const { return count_; }
  /// The error below which this share (0 to 1) of all lies, 0 without any.
  double quantile(double share) const;
  double largest() const { return largest_; }

private:
  std::vector<float> samples_;
  std::size_t count_ = 0, stride_ = 1;
  double largest_ = 0;
};

}  // namespace plumbline
