#pragma once
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace plumbline::gap {

/// What a stretch of residuals says, but for how much its samples count.
struct StretchFit {
  double scale = 0;  ///< of what varies about the mean: the likeliest one, not below the noise
  double about = 0;  ///< log density of what varies, each sample counted in full
  double mean = 0;
  double noise = 0;    ///< least scale of mean and variation
  double samples = 0;  ///< that are finite

  /// As stretchDensity(); share: what a sample counts for.
  double density(double share) const;
  double meanScale(double share) const;  ///< as scaleOfMean()
};

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
  StretchFit fitOf(std::size_t from, std::size_t to, double noise) const;
  /// correlationTime() of the stretch.
  double correlationOf(std::size_t from, std::size_t to) const;

private:
  struct Kept {
    std::size_t from, to;
    double noise;
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
