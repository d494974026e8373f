#include "modules/modeling/attitude/GroundPlane.h"

#include <Eigen/Eigenvalues>

namespace plumbline {
namespace {
constexpr std::size_t fewestPoints = 4;
constexpr double widestTilt = 0.01;    ///< a tilt known worse than this is of no use [rad]
constexpr double largestResidual = 4;  ///< of squared errors against what the variances let expect
}  // namespace

void GroundPlane::add(const Vec3& point, double variance) {
  if (count_ == maxPoints || !(variance > 0) || !point.allFinite()) return;
  points_[count_] = point;
  weights_[count_++] = 1 / variance;
}

bool GroundPlane::fit(const Vec3& eye, Fit& result) const {
  if (count_ < fewestPoints) return false;
  Vec3 centre = Vec3::Zero();
  double total = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    centre += weights_[i] * points_[i];
    total += weights_[i];
  }
  centre /= total;
  Mat3 scatter = Mat3::Zero();
  for (std::size_t i = 0; i < count_; ++i) {
    const Vec3 d = points_[i] - centre;
    scatter += weights_[i] * d * d.transpose();
  }
  // The normal is the direction of least scatter; how far the points reach along the other two says how well
  // its tilt towards them is known.
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(scatter);
  const Vec3 scatters = solver.eigenvalues();
  if (scatters(1) * widestTilt * widestTilt < 1) return false;
  if (scatters(0) > largestResidual * static_cast<double>(count_ - 3)) return false;
  result.up = solver.eigenvectors().col(0);
  if (result.up.dot(eye - centre) < 0) result.up = -result.up;
  result.axes = {solver.eigenvectors().col(2), solver.eigenvectors().col(1)};
  result.variances = {1 / scatters(2), 1 / scatters(1)};
  return true;
}

}  // namespace plumbline
