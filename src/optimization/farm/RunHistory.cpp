#include "optimization/farm/RunHistory.h"

#include <cmath>
#include <limits>

namespace plumbline::farm {

void RunHistory::addResult(std::span<const double> costs) {
  look();
  for (const double cost : costs) {
    if (!std::isfinite(cost)) continue;
    sum_ += cost;
    ++results_;
  }
}

void RunHistory::look() {
  const Optimizer& optimizer = search_.optimizer();
  if (optimizer.generations() == generation_) return;
  generation_ = optimizer.generations();
  const double mean =
      results_ > 0 ? sum_ / static_cast<double>(results_) : std::numeric_limits<double>::quiet_NaN();
  points_.push_back({generation_, search_.runs(), optimizer.bestCost(), mean, optimizer.sigma()});
  sum_ = 0;
  results_ = 0;
  if (points_.size() <= most) return;
  std::vector<Point> fewer;
  for (std::size_t i = (points_.size() - 1) % 2; i < points_.size(); i += 2) fewer.push_back(points_[i]);
  points_ = std::move(fewer);
}

}  // namespace plumbline::farm
