#pragma once
#include "simulation/referee/LimbCollision.h"

namespace plumbline::simulation {

struct FreezeTimes {
  double frozen;  ///< a joint takes no speed for so long [s]
  double thaw;    ///< and then cannot be frozen again for so long [s]
};

/// The joints of a robot that are frozen because limbs passed through each other. (UpdateSelfCollisions)
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
