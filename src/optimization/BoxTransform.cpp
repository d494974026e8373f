#include "optimization/BoxTransform.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

BoxTransform::BoxTransform(const Eigen::VectorXd& lower_, const Eigen::VectorXd& upper_)
    : lower(lower_),
      upper(upper_),
      lowerMargin(lower_.size()),
      upperMargin(lower_.size()),
      bounds_(lower_.array().isFinite().any() || upper_.array().isFinite().any()) {
  for (Eigen::Index i = 0; i < lower.size(); ++i) {
    const double tenth = 0.1 * (upper[i] - lower[i]);
    lowerMargin[i] = std::min(tenth, 0.05 * (1 + std::abs(lower[i])));
    upperMargin[i] = std::min(tenth, 0.05 * (1 + std::abs(upper[i])));
  }
}

double BoxTransform::toBox(Eigen::Index i, double x) const {
  const double l = lower[i], u = upper[i], a = lowerMargin[i], b = upperMargin[i];
  const bool hasLower = std::isfinite(l), hasUpper = std::isfinite(u);
  // The parabola runs from margin outside to margin inside, so one bound turns back at l - a, u + b.
  if (hasLower && hasUpper) {
    const double from = l - a, period = 2 * (u + b - from);
    x -= period * std::floor((x - from) / period);
    if (x > u + b) x = 2 * (u + b) - x;
  } else if (hasLower && x < l - a) {
    x = 2 * (l - a) - x;
  } else if (hasUpper && x > u + b) {
    x = 2 * (u + b) - x;
  }
  if (hasLower && x < l + a) {
    const double d = x - (l - a);
    x = l + d * d / (4 * a);
  } else if (hasUpper && x > u - b) {
    const double d = u + b - x;
    x = u - d * d / (4 * b);
  }
  return std::clamp(x, l, u);
}

double BoxTransform::fromBox(Eigen::Index i, double y) const {
  const double l = lower[i], u = upper[i], a = lowerMargin[i], b = upperMargin[i];
  if (std::isfinite(l) && y < l + a) return l - a + 2 * std::sqrt(a * std::max(0.0, y - l));
  if (std::isfinite(u) && y > u - b) return u + b - 2 * std::sqrt(b * std::max(0.0, u - y));
  return y;
}

Eigen::VectorXd BoxTransform::toBox(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) y[i] = toBox(i, x[i]);
  return y;
}

Eigen::VectorXd BoxTransform::fromBox(const Eigen::VectorXd& y) const {
  Eigen::VectorXd x(y.size());
  for (Eigen::Index i = 0; i < y.size(); ++i) x[i] = fromBox(i, y[i]);
  return x;
}

}  // namespace plumbline
