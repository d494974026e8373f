#include "tactics/FieldGrid.h"

#include <algorithm>
#include <cmath>

#include "math/TablePlace.h"

namespace plumbline {
namespace {

constexpr double fullAdvantage = 2;  ///< a team that is sooner at the ball by so much has it [s]

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
  const TablePlace x = placeInTable(x_, state.place.x());
  const TablePlace y = placeInTable(y_, std::abs(state.place.y()));
  static const std::vector<double> levels{-1, 0, 1};
  const TablePlace a = placeInTable(levels, state.advantage);
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
