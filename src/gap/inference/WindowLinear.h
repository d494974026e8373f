#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/inference/WindowKinds.h"
#include "gap/inference/CoefficientReplayer.h"

namespace plumbline::gap {

/// A set of kinds with strengths [units], in ascending order of kinds.
struct WindowSet {
  std::vector<std::size_t> kinds;
  Eigen::VectorXd x;
  bool holds(std::size_t kind) const;
  double at(std::size_t kind) const;  ///< 0 where it is not in the set
};

/// What a set is worth, see Scored.
struct WindowScore {
  WindowSet set;                         ///< with the strengths that are likeliest in all groups
  std::vector<Eigen::VectorXd> without;  ///< per group: strengths that are likeliest in the others
  std::vector<double> density;           ///< per group: log density under those
  double price = 0;
  std::vector<Eigen::MatrixXd> information;  ///< per group
  double score() const;
};

/// Logarithm of the prior density of strengths: normal, three units wide.
double logPrior(const Eigen::VectorXd& x);

/// Residuals of all windows as a linear function of all strengths about one set's (Gauss-Newton's picture).
class WindowLinear {
public:
  /// slopes: per kind and cell, derivatives of the coefficients by its strength; empty where it is not felt.
  WindowLinear(const std::vector<WindowCell>& cells, std::size_t groups, const std::vector<WindowKind>& kinds,
               WindowSet middle, WindowCoefficients residuals, std::vector<WindowCoefficients> slopes);

  /// Fits the strengths of these kinds (in ascending order), within their bounds and not farther than four
  /// units from the middle, then without each group in turn, and scores what that leaves in it.
  WindowScore score(const std::vector<std::size_t>& kinds) const;
  /// The strengths alone, fitted to all groups.
  Eigen::VectorXd fit(const std::vector<std::size_t>& kinds) const;
  /// Kinds that would gain beside a set, the best first, by the curvature and slope of the log density at it.
  std::vector<std::size_t> proposals(const WindowSet& set, std::size_t most) const;
  const WindowSet& middle() const { return middle_; }

private:
  struct Equations;
  Equations equations(const std::vector<std::size_t>& kinds, const Eigen::VectorXd& at) const;
  Eigen::VectorXd startOf(const std::vector<std::size_t>& kinds) const;
  Eigen::VectorXd solve(const std::vector<std::size_t>& kinds, const Eigen::MatrixXd& information,
                        const Eigen::VectorXd& right) const;
  Eigen::MatrixXd left(std::size_t cell, const std::vector<std::size_t>& kinds,
                       const Eigen::VectorXd& x) const;

  const std::vector<WindowCell>& cells_;
  std::size_t groups_;
  const std::vector<WindowKind>& kinds_;
  WindowSet middle_;
  WindowCoefficients residuals_;
  std::vector<WindowCoefficients> slopes_;
};

}  // namespace plumbline::gap
