#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Kick-off for a side; none: for the side whose turn it is at the start of a half (the left team in the
/// first, the other one in the second, or by lot), otherwise by lot. (GameStateAspect::KickOff)
void startKickOff(Match& match, TeamSide side);

/// Puts players where they must stand when a side is about to kick off. (ClearPlayersBeforeKickOff)
void clearForKickOff(Match& match, TeamSide side);

}  // namespace plumbline::simulation
