#pragma once
#include <vector>

#include "gap/inference/LinearResiduals.h"

namespace plumbline::gap {

/// Sets of causes fitted to coefficients by replays.
class StrengthFitter {
public:
  /// configured: kinds in addition to those that the replayer has.
  explicit StrengthFitter(const CoefficientReplayer& replayer, const std::vector<CauseKind>& configured = {});

  const std::vector<CauseKind>& kinds() const { return kinds_; }
  Explanation causesOf(const StrengthSet& set) const;
  /// Causes of these kinds as a set; those of no kind are left out.
  StrengthSet setOf(const Explanation& causes) const;
  /// Log density of what a set leaves in the cells, and of its strengths.
  double density(const StrengthSet& set) const;
  /// Derivatives at a set by the strengths of some kinds; a change of less than half of what a perfect model
  /// leaves in each channel counts as none.
  LinearResiduals linearise(const StrengthSet& set, const std::vector<std::size_t>& wanted) const;
  std::vector<std::size_t> all() const;
  /// Damped Gauss-Newton steps. Where they gain nothing, steps along each strength in turn (pattern search:
  /// Hooke and Jeeves 1961), for the density is rough in some of them. A sample sees a command or the one
  /// before it, whatever the delay's derivative says. Causes that vanish (below a thousandth of a unit)
  /// go out of the set.
  StrengthSet refine(StrengthSet set, int mostSteps) const;
  /// Whether two kinds cannot be in one set: two variants of one cause.
  bool exclude(std::size_t a, std::size_t b) const;

private:
  /// Both return the density where they end, and move the set there.
  double step(StrengthSet& set, double now) const;
  double sweep(StrengthSet& set, double now, Eigen::VectorXd& steps) const;
  double stepOf(const StrengthSet& set, std::size_t kind) const;
  void slopesOf(const StrengthSet& at, const Coefficients& here, const std::vector<std::size_t>& wanted,
                std::vector<Coefficients>& slopes) const;

  const CoefficientReplayer& replayer_;
  std::vector<CauseKind> kinds_;
};

/// A set with a kind more (strength 0), or without one.
StrengthSet with(const StrengthSet& set, std::size_t kind);
StrengthSet without(const StrengthSet& set, std::size_t kind);

}  // namespace plumbline::gap
