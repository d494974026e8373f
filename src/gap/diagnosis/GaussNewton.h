#pragma once
#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// What a fit by damped Gauss-Newton steps came to.
struct GaussNewtonFit {
  Explanation causes;
  double fitting = 0;    ///< sum of squares on the blocks for fitting
  bool settled = false;  ///< the last step changed next to nothing, as predicted
};

/// Values of some of the causes (indices in group) fitted together by damped Gauss-Newton steps in the
/// logarithms of their strengths, from where they are, on the blocks for fitting (Marquardt, An Algorithm for
/// Least-Squares Estimation of Nonlinear Parameters, 1963). Each step replays once per cause and once for
/// every try. Held base only: std::logic_error with runs on the feet.
GaussNewtonFit gaussNewton(const Evaluator& evaluator, const Explanation& causes,
                           const std::vector<std::size_t>& group, int jobs);

}  // namespace plumbline::gap
