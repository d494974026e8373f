#pragma once
#include <optional>

#include "tactics/approach/ApproachPlanner.h"

namespace plumbline {

/// Walks to a pose without a ball, cycle by cycle: from afar by walkToPose, the last metres as planned.
class WalkToPlace {
public:
  /// The walk's request of a cycle. T_robot_place: the pose in the robot's frame [m, rad]; speed: walked now,
  /// forward, sideways, turn [m/s, rad/s]; detour: a way point that comes first, in the robot's frame [m].
  WalkCommand update(const Pose2& T_robot_place, const Vec3& speed, const WalkLimits& limits,
                     const std::optional<Vec2>& detour, const WalkToPoseParameters& walk,
                     const ApproachPlannerParameters& plan);
  /// The robot goes nowhere in this cycle.
  void leave();

private:
  ApproachPlanner planner_;
  bool sprinting_ = false;
};

}  // namespace plumbline
