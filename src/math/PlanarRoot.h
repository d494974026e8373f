#pragma once
#include "math/Types.h"

namespace plumbline {

struct PlanarRoot {
  Vec2 x = Vec2::Zero();      ///< argument of the last evaluation
  Vec2 error = Vec2::Zero();  ///< f(x)
  int evaluations = 0;
  bool converged = false;
};

/// Argument where a smooth function of the plane into the plane vanishes, using only its values. After a
/// first small step along the error (factor firstStep) come Newton steps. Their gradient begins as the
/// rotation and scaling that the first step showed (exact for f(x) = s R x + b) and learns by Broyden's rank-
/// one update. Stops at |f| <= threshold or after maxEvaluations.
template <class Function>
PlanarRoot findPlanarRoot(const Function& f, const Vec2& start, double threshold, int maxEvaluations,
                          double firstStep = -1e-4) {
  PlanarRoot root;
  root.x = start;
  Mat2 gradient = Mat2::Identity();
  Vec2 step = Vec2::Zero(), previous = Vec2::Zero();
  while (true) {
    root.error = f(root.x);
    ++root.evaluations;
    root.converged = root.error.norm() <= threshold;
    if (root.converged || root.evaluations >= maxEvaluations || !root.error.allFinite()) return root;
    if (root.evaluations == 1) {
      step = firstStep * root.error;
    } else {
      const Vec2 change = root.error - previous;
      const double square = step.squaredNorm();
      if (root.evaluations == 2) {
        const double c = change.dot(step) / square,
                     s = (step.x() * change.y() - step.y() * change.x()) / square;
        gradient << c, -s, s, c;
      } else {
        gradient += (change - gradient * step) * step.transpose() / square;
      }
      const double determinant = gradient(0, 0) * gradient(1, 1) - gradient(0, 1) * gradient(1, 0);
      if (!(std::abs(determinant) > 1e-12)) return root;
      Mat2 inverse;
      inverse << gradient(1, 1), -gradient(0, 1), -gradient(1, 0), gradient(0, 0);
      step = -(inverse * root.error) / determinant;
    }
    previous = root.error;
    root.x += step;
  }
}

}  // namespace plumbline
