#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// The ball in a goal is a goal for the other team. It is a goal kick instead if they scored straight from
/// their kick-off, from an indirect restart, or too soon after a pass mode. It is a corner kick for them if
/// their opponents put a restart into their own goal (CheckGoal, PunishIndirectKickGoal). After a goal the
/// clock runs for three seconds, players are put to where they must stand, and the other team kicks off
/// (UpdateGoal).
class Goal : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, true, "", {}, "goals count")
  };
  void play(Match& match) override;
};

}  // namespace plumbline::simulation
