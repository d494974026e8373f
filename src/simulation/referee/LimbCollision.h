#pragma once
#include <bitset>
#include <vector>

#include "robot/RobotModel.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

using JointSet = std::bitset<maxJoints>;

/// All joints of what hangs on the torso in one place, as an arm or a leg; none: the torso.
using Limb = JointSet;

/// Two limbs of a robot that pass through each other.
struct LimbCollision {
  Limb a, b;
};

/// Where boxes of a robot overlap by more than a tolerance [m]. A box and its parent are not checked. As on
/// the league's server two boxes with an edge of each in the same direction never collide.
/// (BoxCollider::CheckCollisions)
std::vector<LimbCollision> limbCollisions(const World& world, RobotHandle robot, const RobotModel& model,
                                          double tolerance);

}  // namespace plumbline::simulation
