#include "simulation/physics/bullet/PrincipalAxes.h"

#include <Eigen/Eigenvalues>

namespace plumbline::simulation::bullet {

Mat3 principalAxesOf(const Mat3& inertia) {
  if (inertia.isDiagonal(1e-12)) return Mat3::Identity();
  Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(inertia).eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return axes;
}

}  // namespace plumbline::simulation::bullet
