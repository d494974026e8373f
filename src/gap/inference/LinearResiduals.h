#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/inference/CauseKinds.h"
#include "gap/inference/CoefficientReplayer.h"

namespace plumbline::gap {

/// A set of kinds with strengths [units], in ascending order of kinds.
struct StrengthSet {
  std::vector<std::size_t> kinds;
  Eigen::VectorXd x;
  bool holds(std::size_t kind) const;
  double at(std::size_t kind) const;  ///< 0 where it is not in the set
};

/// What a set is worth, see Scored.
struct SetScore {
  StrengthSet set;                       ///< with the strengths that are likeliest in all groups
  std::vector<Eigen::VectorXd> without;  ///< per group: strengths that are likeliest in the others
  std::vector<double> density;           ///< per group: log density under those
  double price = 0;
  std::vector<Eigen::MatrixXd> information;  ///< per group
  double score() const;
};

/// Logarithm of the prior density of strengths: normal, three units wide.
double logPrior(const Eigen::VectorXd& x);

/// Residuals of all cells as a linear function of all strengths about one set's (Gauss-Newton's picture).
class LinearResiduals {
public:
  /// slopes: per kind and cell, derivatives of the coefficients by its strength; empty where it is not felt.
  LinearResiduals(const std::vector<CoefficientCell>& cells, std::size_t groups,
                  const std::vector<CauseKind>& kinds, StrengthSet middle, Coefficients residuals,
                  std::vector<Coefficients> slopes);

  /// Fits the strengths of these kinds (in ascending order), within their bounds and not farther than four
  /// units from the middle, then without each group in turn, and scores what that leaves in it.
  SetScore score(const std::vector<std::size_t>& kinds) const;
  /// The strengths alone, fitted to all groups.
  Eigen::VectorXd fit(const std::vector<std::size_t>& kinds) const;
  /// Kinds that would gain if added to a set, best first, by curvature and slope of the log density at it.
  std::vector<std::size_t> proposals(const StrengthSet& set, std::size_t most) const;
  const StrengthSet& middle() const { return middle_; }

private:
  struct Equations;
  Equations equations(const std::vector<std::size_t>& kinds, const Eigen::VectorXd& at) const;
  Eigen::VectorXd startOf(const std::vector<std::size_t>& kinds) const;
  Eigen::VectorXd solve(const std::vector<std::size_t>& kinds, const Eigen::MatrixXd& information,
                        const Eigen::VectorXd& right) const;
  Eigen::MatrixXd left(std::size_t cell, const std::vector<std::size_t>& kinds,
                       const Eigen::VectorXd& x) const;

  const std::vector<CoefficientCell>& cells_;
  std::size_t groups_;
  const std::vector<CauseKind>& kinds_;
  StrengthSet middle_;
  Coefficients residuals_;
  std::vector<Coefficients> slopes_;
};

}  // namespace plumbline::gap
