#include "gap/inference/Strengths.h"

#include <algorithm>
#include <cmath>

namespace plumbline::gap {

namespace {

/// Share of the least start: below the limit of doesNothing(), which so notices that a cause has vanished.
constexpr double minStrength = 2e-5;

}  // namespace

std::vector<Cause> startsOf(const Mechanism& robot, const Cause& kind) {
  std::vector<Cause> starts;
  for (const double value : kind.effect->starts) {
    Cause start = kind;
    start.value = value * kind.effect->scaleAt(robot, kind.place);
    starts.push_back(withLogStrengths(robot, {start}, logStrengths({start})).front());
  }
  return starts;
}

double leastStart(const Mechanism& robot, const Cause& cause) {
  const double scale = cause.effect->scaleAt(robot, cause.place);
  double least = HUGE_VAL;
  for (const double start : cause.effect->starts)
    least = std::min(least, std::abs(cause.effect->strengthOf(start * scale)));
  return least;
}

Cause withStrength(const Mechanism& robot, Cause cause, double strength) {
  const Bounds bounds = cause.effect->boundsAt(robot, cause.place);
  // A reciprocal strength of minus the nominal one's would be an infinite value.
  double value = cause.effect->valueAt(strength);
  if (cause.effect->reciprocal && strength + 1 / cause.effect->nominal <= 1 / bounds.upper)
    value = bounds.upper;
  cause.value = std::clamp(value, bounds.lower, bounds.upper);
  return cause;
}

Eigen::VectorXd logStrengths(const Explanation& causes) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(causes.size()));
  for (std::size_t i = 0; i < causes.size(); ++i)
    x[static_cast<Eigen::Index>(i)] =
        std::log(std::max(1e-300, std::abs(causes[i].effect->strengthOf(causes[i].value))));
  return x;
}

Explanation withLogStrengths(const Mechanism& robot, Explanation causes, const Eigen::VectorXd& x) {
  for (std::size_t i = 0; i < causes.size(); ++i) {
    Cause& cause = causes[i];
    const double sign = cause.effect->strengthOf(cause.value) < 0 ? -1 : 1;
    const double strength =
        std::max(minStrength * leastStart(robot, cause), std::exp(x[static_cast<Eigen::Index>(i)]));
    cause = withStrength(robot, cause, sign * strength);
  }
  return causes;
}

}  // namespace plumbline::gap
