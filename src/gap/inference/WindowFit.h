#pragma once
#include <vector>

#include "gap/inference/WindowLinear.h"

namespace plumbline::gap {

/// Sets of causes fitted to windows by replays.
class WindowFitter {
public:
  explicit WindowFitter(const WindowReplayer& replayer);

  const std::vector<WindowKind>& kinds() const { return kinds_; }
  Explanation causesOf(const WindowSet& set) const;
  /// Log density of what a set leaves in the windows, and of its strengths.
  double density(const WindowSet& set) const;
  /// Derivatives beside a set by the strengths of some kinds; what changes no channel by half its noise is
  /// not felt.
  WindowLinear linearise(const WindowSet& set, const std::vector<std::size_t>& wanted) const;
  std::vector<std::size_t> all() const;
  /// Damped Gauss-Newton steps. Causes that vanish (below a thousandth of a unit) go out of the set.
  WindowSet refine(WindowSet set, int mostSteps) const;
  /// Whether two kinds cannot be in one set: two variants of one cause, a joint's and that of all joints.
  bool exclude(std::size_t a, std::size_t b) const;

private:
  double stepOf(const WindowSet& set, std::size_t kind) const;
  void slopesOf(const WindowSet& beside, const std::vector<std::size_t>& wanted,
                std::vector<WindowCoefficients>& slopes) const;

  const WindowReplayer& replayer_;
  std::vector<WindowKind> kinds_;
};

/// A set with a kind more (strength 0), or without one.
WindowSet with(const WindowSet& set, std::size_t kind);
WindowSet without(const WindowSet& set, std::size_t kind);

}  // namespace plumbline::gap
