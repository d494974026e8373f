#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "optimization/Search.h"

namespace plumbline::farm {

/// How a search converged, a point for each generation; from all results, in the order in which they came.
class RunHistory {
public:
  static constexpr std::size_t most = 2000;  ///< points; then every second one goes, but never the last

  struct Point {
    std::int64_t generation = 0, runs = 0;
    double best = 0;   ///< cost of the best candidate up to there
    double mean = 0;   ///< cost of the results since the point before; NaN where none was a number
    double sigma = 0;  ///< of the candidates, in units of the first
  };

  explicit RunHistory(const Search& search) : search_(search) {}

  /// Before the search takes the result; without costs: it was given up.
  void addResult(std::span<const double> costs);
  /// After the search took its results.
  void look();
  const std::vector<Point>& points() const { return points_; }

private:
  const Search& search_;
  std::vector<Point> points_;
  std::int64_t generation_ = 0, results_ = 0;
  double sum_ = 0;
};

}  // namespace plumbline::farm
