#pragma once
#include <array>

namespace plumbline {

/// Angles of one leg from hip yaw pitch to ankle roll [rad], in the order of JointId; the toe is not moved.
using LegAngles = std::array<double, 6>;

struct LegSolution {
  LegAngles angles{};
  /// False if the pose cannot be reached; angles then reach the nearest pose found.
  bool reachable = true;
};

}  // namespace plumbline
