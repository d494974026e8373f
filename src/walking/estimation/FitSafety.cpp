#include "walking/estimation/FitSafety.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {
namespace {

constexpr double safeVelocity = 0.05;  ///< change of the velocity when a step begins [m/s]
constexpr double safePlace = 0.01;     ///< change of the feet's place under the mass [m]

}  // namespace

FitSafety::FitSafety(std::span<const ObservedStep> steps) {
  if (steps.empty()) return;
  pendulum_ = steps.back().pendulum;
  const auto count = static_cast<double>(steps.size());
  duration_ = feetDistance_ = 0;
  for (const ObservedStep& step : steps) {
    const double time = step.samples.empty() ? 0.2 : step.samples.back().time;
    duration_ += time / count;
    feetDistance_ += 2 * std::abs(step.begin.supportFoot().y()) / count;
    speed_ += step.begin.velocity.x() / count;
  }
}

ReferenceTrajectory FitSafety::walk(double forward, const ModelParameters& parameters) const {
  const LinearInvertedPendulum model = pendulum_.with(parameters);
  return findReferenceTrajectory(
      model, {Vec2(forward, 0), 0, duration_, feetDistance_, pendulum_.copOffset - model.balance()});
}

double FitSafety::change(const ModelParameters& parameters) const {
  const Vec2 place = pendulum_.with(parameters).balance();
  double most = place.norm() / safePlace;
  for (const double forward : {0.0, 0.2, -0.2, speed_}) {
    const ReferenceTrajectory plain = walk(forward, {}), fitted = walk(forward, parameters);
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec2 change = fitted.begin[i].velocity - plain.begin[i].velocity;
      most = std::max(most, change.cwiseAbs().maxCoeff() / safeVelocity);
    }
  }
  return std::isfinite(most) ? most : 1e3;
}

}  // namespace plumbline::walking
