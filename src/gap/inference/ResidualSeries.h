#pragma once
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include "gap/inference/Likelihood.h"

namespace plumbline::gap {

/// Residuals of one channel of one trial, per cycle; NaN where nothing was measured. They never change, and
/// what was once worked out of a stretch is kept: most hypotheses leave most chains as they were.
class ResidualSeries {
public:
  explicit ResidualSeries(std::vector<double> values) : values_(std::move(values)) {}

  double operator[](std::size_t k) const { return values_[k]; }
  std::size_t size() const { return values_.size(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }
  friend bool operator==(const ResidualSeries& a, const ResidualSeries& b) { return a.values_ == b.values_; }

  /// Cycles [from, to), empty where the series ends before; noise: least scale.
  std::vector<double> stretch(std::size_t from, std::size_t to) const;
  /// fitStretch() of the stretch.
  StretchFit fitOf(std::size_t from, std::size_t to, double noise) const;
  /// correlationTime() of the stretch.
  double correlationOf(std::size_t from, std::size_t to) const;

private:
  struct Kept {
    std::size_t from, to;
    StretchFit fit;
  };
  struct KeptTime {
    std::size_t from, to;
    double time;
  };
  std::vector<double> values_;
  mutable std::mutex mutex_;
  mutable std::vector<Kept> fits_;
  mutable std::vector<KeptTime> times_;
};

}  // namespace plumbline::gap
