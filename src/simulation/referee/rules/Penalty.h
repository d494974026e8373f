#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Punishes reported fouls: each is sent to monitors in every cycle until the player is moved. An offender is
/// held a metre above the ground for half a second, then put outside the field, unless its foul's rule has
/// moved it already. (ClearPlayersAutomatic)
class Penalty : public Rule {
public:
  void punish(Match& match) override;
};

}  // namespace plumbline::simulation
