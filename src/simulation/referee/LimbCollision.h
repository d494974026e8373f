#pragma once
#include <bitset>
#include <vector>

#include "robot/RobotModel.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

using JointSet = std::bitset<maxJoints>;

/// All joints of an arm or leg; none, first 0 and last -1: the torso.
struct Limb {
  int first, last;
};

/// Two limbs of a robot that pass through each other.
struct LimbCollision {
  Limb a, b;
};

/// Where boxes of a robot overlap by more than a tolerance [m]. A box and its parent are not checked. As on
/// the league's server two boxes with an edge of each in the same direction never collide.
/// (BoxCollider::CheckCollisions)
std::vector<LimbCollision> limbCollisions(const World& world, RobotHandle robot, const RobotModel& model,
                                          double tolerance);

struct FreezeTimes {
  double frozen = 1, thaw = 2;  ///< [s]
};

/// The joints of a robot that take no speed for a time, and then cannot be frozen again for another.
/// (UpdateSelfCollisions)
class FrozenLimbs {
public:
  FrozenLimbs() { last_.fill(never); }
  /// At this time [s]; true if a joint is frozen that was free.
  bool freeze(const Limb& limb, double time, const FreezeTimes& times);
  /// Thaws joints whose time is over, or all.
  void thaw(double time, const FreezeTimes& times, bool all = false);
  const JointSet& joints() const { return joints_; }

private:
  static constexpr double never = -1000;  ///< a time long ago [s]

  JointSet joints_;
  JointArray last_;  ///< when each was frozen [s]
};

}  // namespace plumbline::simulation
