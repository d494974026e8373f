#pragma once
#include "simulation/referee/FrozenLimbs.h"
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Limbs that pass through each other. When two boxes of a robot overlap by more than 0.04 m, all joints of
/// their arms and legs accept no speed for a second. For two more seconds they cannot be frozen again; the
/// torso has none. A box and its parent are not checked. As on the league's server two boxes with an edge of
/// each in the same direction never collide. Each such event is reported as a foul.
/// (AnalyseSelfCollisionFouls, BoxCollider::CheckCollisions, UpdateSelfCollisions)
class SelfCollision : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, true, "", {}, "whether limbs freeze")
    PARAMETER(double, tolerance, 0.04, "m", Range::atLeast(0), "how far boxes may sink into each other")
    PARAMETER(double, frozen, 1, "s", Range::atLeast(0), "joints of such limbs take no speed")
    PARAMETER(double, thaw, 2, "s", Range::atLeast(0), "and cannot be frozen again")
    PARAMETER(bool, putOutside, false, "", {}, "instead of freezing")
    PARAMETER(double, cooldown, 10, "s", Range::atLeast(0), "between two such")
    FreezeTimes times() const { return {frozen, thaw}; }
  };
  void judgeAll(Match& match) override;
  /// Thaws joints whose time is over; all while play is suspended.
  void end(Match& match) override;
};

}  // namespace plumbline::simulation
