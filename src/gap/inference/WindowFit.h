#pragma once
#include <vector>

#include "gap/inference/WindowLinear.h"

namespace plumbline::gap {

/// Sets of causes fitted to windows by replays.
class WindowFitter {
public:
  explicit WindowFitter(const CoefficientReplayer& replayer);

  const std::vector<WindowKind>& kinds() const { return kinds_; }
  Explanation causesOf(const WindowSet& set) const;
  /// Log density of what a set leaves in the windows, and of its strengths.
  double density(const WindowSet& set) const;
  /// Derivatives beside a set by the strengths of some kinds; what changes no channel by half of what a
  /// perfect model leaves in it is not felt.
  WindowLinear linearise(const WindowSet& set, const std::vector<std::size_t>& wanted) const;
  std::vector<std::size_t> all() const;
  /// Damped Gauss-Newton steps, and where they gain nothing, steps along each strength in turn (pattern
  /// search: Hooke and Jeeves 1961), for the density is rough in some of them: a sample sees a command or the
  /// one before it, whatever the delay's derivative says. Causes that vanish (below a thousandth of a unit)
  /// go out of the set.
  WindowSet refine(WindowSet set, int mostSteps) const;
  /// Whether two kinds cannot be in one set: two variants of one cause, a joint's and that of all joints.
  bool exclude(std::size_t a, std::size_t b) const;

private:
  /// Both return the density where they end, and move the set there.
  double step(WindowSet& set, double now) const;
  double sweep(WindowSet& set, double now, Eigen::VectorXd& steps) const;
  double stepOf(const WindowSet& set, std::size_t kind) const;
  void slopesOf(const WindowSet& beside, const WindowCoefficients& here,
                const std::vector<std::size_t>& wanted, std::vector<WindowCoefficients>& slopes) const;

  const CoefficientReplayer& replayer_;
  std::vector<WindowKind> kinds_;
};

/// A set with a kind more (strength 0), or without one.
WindowSet with(const WindowSet& set, std::size_t kind);
WindowSet without(const WindowSet& set, std::size_t kind);

}  // namespace plumbline::gap
