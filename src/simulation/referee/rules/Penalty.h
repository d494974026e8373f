#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// What follows from the fouls called: each is reported, in every cycle until it is dealt with. An offender
/// is held a metre above the ground for half a second, then put beside the field, unless its foul's rule has
/// moved it already. (ClearPlayersAutomatic)
class Penalty : public Rule {
public:
  void punish(Match& match) override;
};

}  // namespace plumbline::simulation
