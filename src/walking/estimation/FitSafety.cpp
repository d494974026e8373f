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
  pendulum = steps.back().pendulum;
  const auto count = static_cast<double>(steps.size());
  duration = feetDistance = 0;
  for (const ObservedStep& step : steps) {
    const double time = step.samples.empty() ? 0.2 : step.samples.back().time;
    duration += time / count;
    feetDistance += 2 * std::abs(step.begin.supportFoot().y()) / count;
    speed += step.begin.velocity.x() / count;
  }
}

ReferenceTrajectory FitSafety::walk(double forward, const ModelParameters& parameters) const {
  const LinearInvertedPendulum model = pendulum.with(parameters);
  return findReferenceTrajectory(
      model, {Vec2(forward, 0), 0, duration, feetDistance, pendulum.copOffset - model.balance()});
}

double FitSafety::change(const ModelParameters& parameters) const {
  const Vec2 place = pendulum.with(parameters).balance();
  double most = place.norm() / safePlace;
  for (const double forward : {0.0, 0.2, -0.2, speed}) {
    const ReferenceTrajectory plain = walk(forward, {}), fitted = walk(forward, parameters);
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec2 change = fitted.begin[i].velocity - plain.begin[i].velocity;
      most = std::max(most, change.cwiseAbs().maxCoeff() / safeVelocity);
    }
  }
  return std::isfinite(most) ? most : 1e3;
}

}  // namespace plumbline::walking
