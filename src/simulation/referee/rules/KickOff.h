#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Kick-off for a side; none: for the side whose turn it is at the start of a half (the left team in the
/// first, the other one in the second, or by lot), otherwise by lot. (GameStateAspect::KickOff)
void startKickOff(Match& match, TeamSide side);

/// Before the kick-off the ball lies in the middle, and everybody stands in the own half; all this as soon as
/// somebody is there. (UpdateBeforeKickOff)
void beforeKickOff(Match& match);

/// The other team keeps out of the ring, the side's own players may stand in it; play is on when a player
/// touches the ball, and after 15 s by a drop ball. (UpdateKickOff)
void kickingOff(Match& match, TeamSide side);

/// Puts players where they must stand when a side is about to kick off. (ClearPlayersBeforeKickOff)
void clearForKickOff(Match& match, TeamSide side);

/// The kick-off's team may score when an opponent has touched the ball, or one of its own players outside the
/// ring. With up to two robots in the game it always may. (Update)
void watchKickOff(Match& match);

}  // namespace plumbline::simulation
