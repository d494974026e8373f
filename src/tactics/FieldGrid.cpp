#include "tactics/FieldGrid.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr double fullAdvantage = 2;  ///< a team that is sooner at the ball by so much has it [s]

struct Share {
  std::size_t first = 0;
  double second = 0;  ///< the weight of the point after it
};

Share between(const std::vector<double>& values, double value) {
  const auto upper = std::upper_bound(values.begin() + 1, values.end() - 1, value);
  const auto i = static_cast<std::size_t>(upper - values.begin()) - 1;
  return {i, std::clamp((value - values[i]) / (values[i + 1] - values[i]), 0.0, 1.0)};
}

}  // namespace

double ballAdvantage(double ourSeconds, double theirSeconds) {
  return std::clamp((theirSeconds - ourSeconds) / fullAdvantage, -1.0, 1.0);
}

FieldGrid::FieldGrid(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {}

BallState FieldGrid::state(std::size_t point) const {
  const std::size_t ix = point % x_.size(), iy = point / x_.size() % y_.size();
  const std::size_t ia = point / (x_.size() * y_.size());
  return {Vec2(x_[ix], y_[iy]), static_cast<double>(ia) - 1};
}

std::array<FieldGrid::Weight, 8> FieldGrid::weights(const BallState& state) const {
  const Share x = between(x_, state.place.x()), y = between(y_, std::abs(state.place.y()));
  static const std::vector<double> levels{-1, 0, 1};
  const Share a = between(levels, state.advantage);
  std::array<Weight, 8> weights;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const std::size_t dx = corner & 1, dy = corner >> 1 & 1, da = corner >> 2;
    weights[corner].point = point(x.first + dx, y.first + dy, a.first + da);
    weights[corner].weight =
        (dx ? x.second : 1 - x.second) * (dy ? y.second : 1 - y.second) * (da ? a.second : 1 - a.second);
  }
  return weights;
}

}  // namespace plumbline
