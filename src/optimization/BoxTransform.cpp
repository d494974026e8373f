#include "optimization/BoxTransform.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

BoxTransform::BoxTransform(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper)
    : lower_(lower),
      upper_(upper),
      lowerMargin_(lower.size()),
      upperMargin_(lower.size()),
      bounds_(lower.array().isFinite().any() || upper.array().isFinite().any()) {
  for (Eigen::Index i = 0; i < lower_.size(); ++i) {
    const double tenth = 0.1 * (upper_[i] - lower_[i]);
    lowerMargin_[i] = std::min(tenth, 0.05 * (1 + std::abs(lower_[i])));
    upperMargin_[i] = std::min(tenth, 0.05 * (1 + std::abs(upper_[i])));
  }
}

double BoxTransform::toBox(Eigen::Index i, double x) const {
  const double l = lower_[i], u = upper_[i], a = lowerMargin_[i], b = upperMargin_[i];
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
  const double l = lower_[i], u = upper_[i], a = lowerMargin_[i], b = upperMargin_[i];
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
