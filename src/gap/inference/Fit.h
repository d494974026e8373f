#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/inference/Density.h"

namespace plumbline::gap {

/// Causes with the values that are likeliest on some groups.
struct Fitted {
  Explanation causes;
  double density = 0;  ///< on the groups that were fitted
  /// Per group, at these values and in logarithms of strengths: minus the second derivative of the log
  /// density (Gauss-Newton's) and its gradient; zero for groups left out.
  std::vector<Eigen::MatrixXd> information;
  std::vector<Eigen::VectorXd> gradient;
};

/// Damped Gauss-Newton steps in the logarithms of the strengths from where they are (Marquardt 1963), each
/// residual weighted by the Student-t density at its cell's scale (iteratively reweighted least squares).
/// Strengths of causes that stick are also tried on both sides, since derivatives there lead nowhere.
/// wantedGroups: those fitted; empty: all.
Fitted fit(const Replayer& replayer, const Shares& shares, const Explanation& start, int mostSteps,
           const std::vector<char>& wantedGroups = {});

}  // namespace plumbline::gap
