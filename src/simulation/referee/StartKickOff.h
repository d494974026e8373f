#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Kick-off for a side. none: at the start of a half the side that begins it (the left team in the first
/// half, the other one in the second, or a random one), otherwise a random side. (GameStateAspect::KickOff)
void startKickOff(Match& match, TeamSide side);

/// Puts players where they must stand when a side is about to kick off. (ClearPlayersBeforeKickOff)
void clearForKickOff(Match& match, TeamSide side);

}  // namespace plumbline::simulation
