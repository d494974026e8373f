#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// What follows from the fouls called: each is reported, in every cycle until it is dealt with. An offender
/// is held a metre above the ground for half a second, then put beside the field; one of illegal defence or
/// touching has been moved already. (ClearPlayersAutomatic)
void punishOffenders(Match& match);

}  // namespace plumbline::simulation
