#pragma once
#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Result of a fit by damped Gauss-Newton steps.
struct GaussNewtonFit {
  Explanation causes;
  double fitting = 0;    ///< sum of squares on the blocks for fitting
  bool settled = false;  ///< the last step changed next to nothing, as predicted
};

/// Fits the values of some causes (indices in group) together on the blocks for fitting, by damped
/// Gauss-Newton steps in the logarithms of their strengths (Marquardt, An Algorithm for Least-Squares
/// Estimation of Nonlinear Parameters, 1963). Each step replays once per cause and once for every try. Fixed
/// base only: std::logic_error with runs on the feet.
GaussNewtonFit gaussNewton(const Evaluator& evaluator, const Explanation& causes,
                           const std::vector<std::size_t>& group, int jobs);

}  // namespace plumbline::gap
