#include "tactics/FieldValueLearner.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/NormalDistribution.h"

namespace plumbline {
namespace {

constexpr double settled = 1e-10;  ///< largest change of a value by a sweep
constexpr int mostSweeps = 100000;
constexpr double changesHands = 0.25;  ///< weight of another advantage per step of advantage, in the prior

}  // namespace

FieldValueLearner::FieldValueLearner(FieldGrid grid, const Options& options)
    : grid_(std::move(grid)), options_(options), counts_(grid_.size() * (grid_.size() + 2)) {
  addPrior();
}

void FieldValueLearner::addPrior() {
  const std::size_t points = grid_.size();
  const double deviation = options_.priorDeviation;
  const auto bell = [deviation](double way) { return std::exp(-0.5 * way * way / (deviation * deviation)); };
  std::vector<double> weights(points + 2);
  for (std::size_t i = 0; i < points; ++i) {
    BallState from = grid_.state(i);
    from.place.x() += options_.priorDrift * from.advantage;
    for (std::size_t j = 0; j < points; ++j) {
      const BallState to = grid_.state(j);
      weights[j] = bell((to.place - from.place).norm()) *
                   std::pow(changesHands, std::abs(to.advantage - from.advantage));
    }
    const double sum =
        std::accumulate(weights.begin(), weights.begin() + static_cast<std::ptrdiff_t>(points), 0.0);
    // The share of a bell that lies behind the line, between the posts.
    const auto behind = [&](double x) {
      const double y = std::abs(from.place.y());
      const double mouth = 0.5 * (std::erf((options_.goalHalfWidth - y) / deviation / std::sqrt(2.0)) +
                                  std::erf((options_.goalHalfWidth + y) / deviation / std::sqrt(2.0)));
      return mouth * shareBelow((x - options_.goalX) / deviation);
    };
    const double ours = behind(from.place.x()), theirs = behind(-from.place.x());
    for (std::size_t j = 0; j < points; ++j)
      count(i, j) += options_.priorSteps * std::max(0.0, 1 - ours - theirs) * weights[j] / sum;
    count(i, points) += options_.priorSteps * ours;
    count(i, points + 1) += options_.priorSteps * theirs;
  }
}

void FieldValueLearner::add(const BallState& from, const BallState& to) {
  for (const FieldGrid::Weight& a : grid_.weights(from))
    for (const FieldGrid::Weight& b : grid_.weights(to)) count(a.point, b.point) += a.weight * b.weight;
}

void FieldValueLearner::addStep(const BallState& from, const BallState& to) {
  add(from, to);
  add(from.mirrored(), to.mirrored());
  ++steps_;
}

void FieldValueLearner::addGoal(const BallState& from, bool ours) {
  for (const FieldGrid::Weight& a : grid_.weights(from))
    count(a.point, grid_.size() + (ours ? 0 : 1)) += a.weight;
  for (const FieldGrid::Weight& a : grid_.weights(from.mirrored()))
    count(a.point, grid_.size() + (ours ? 1 : 0)) += a.weight;
  ++steps_;
  ++goals_;
}

FieldValue FieldValueLearner::learn() const {
  const std::size_t points = grid_.size();
  std::vector<double> values(points, 0.0);
  for (int sweep = 0; sweep < mostSweeps; ++sweep) {
    double change = 0;
    for (std::size_t i = 0; i < points; ++i) {
      const double* row = &counts_[i * (points + 2)];
      double sum = row[points] + row[points + 1], value = row[points] - row[points + 1];
      // A step to the point itself tells nothing of where it ends.
      for (std::size_t j = 0; j < points; ++j)
        if (j != i) {
          sum += row[j];
          value += row[j] * values[j];
        }
      if (sum <= 0) continue;
      change = std::max(change, std::abs(value / sum - values[i]));
      values[i] = value / sum;
    }
    if (change < settled) break;
  }
  return FieldValue(grid_, std::move(values));
}

}  // namespace plumbline
