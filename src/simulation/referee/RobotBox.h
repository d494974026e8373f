#pragma once
#include "simulation/referee/Areas.h"
#include "simulation/referee/Participant.h"

namespace plumbline::simulation {

/// Axis-parallel box around a robot, in the field frame [m].
struct RobotBox {
  Vec3 low, high;
  /// Whether a ball of that radius around the centre reaches into the box.
  bool reachedBy(const Vec3& centre, double radius) const;
};

/// Bounding box of a robot as on the league's server: all its bodies, and a plate of 0.56 x 0.4 m around the
/// torso's middle. Measured by thresholds of a standing robot of type 0, from all sides.
RobotBox robotBox(const World& world, const Participant& player);
/// From above, around the middles of its colliding bodies: with these alone the server judges who is in a
/// half or a penalty area.
Area robotArea(const World& world, const Participant& player);

}  // namespace plumbline::simulation
