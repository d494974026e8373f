#pragma once
#include <limits>
#include <string>

namespace plumbline {

/// Bounds of a number, both included: `Range(0, 1)`, `Range::atLeast(0)`, `Range::atMost(1)`, `Range()`:
/// none.
struct Range {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  double min = -infinity;
  double max = infinity;

  constexpr Range() = default;
  constexpr Range(double lowest, double highest) : min(lowest), max(highest) {}
  static constexpr Range atLeast(double min) { return {min, infinity}; }
  static constexpr Range atMost(double max) { return {-infinity, max}; }

  /// False for NaN.
  constexpr bool contains(double value) const { return value >= min && value <= max; }
};

/// The shortest text that reads back as the same number.
std::string shortestText(double value);
std::string shortestText(float value);

/// "at least 0", "at most 1" or "within [0, 1]".
std::string boundsText(const Range& range);

}  // namespace plumbline
