#pragma once
#include <Eigen/Core>
#include <cmath>

namespace plumbline {

// Test functions of the literature; the least value of each is 0.

inline double sphere(const Eigen::VectorXd& x) { return x.squaredNorm(); }

/// Condition number 1e6.
inline double ellipsoid(const Eigen::VectorXd& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    sum += std::pow(1e6, static_cast<double>(i) / static_cast<double>(x.size() - 1)) * x[i] * x[i];
  return sum;
}

inline double rosenbrock(const Eigen::VectorXd& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i)
    sum += 100 * std::pow(x[i] * x[i] - x[i + 1], 2) + std::pow(x[i] - 1, 2);
  return sum;
}

/// Many local minima.
inline double rastrigin(const Eigen::VectorXd& x) {
  double sum = 10.0 * static_cast<double>(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) sum += x[i] * x[i] - 10 * std::cos(2 * M_PI * x[i]);
  return sum;
}

}  // namespace plumbline
