#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Whether the ball is in a goal, and what follows: a goal for the other team; a goal kick instead if they
/// scored straight from their kick-off, from an indirect restart, or too soon after a pass mode; a corner
/// kick for them if their opponents put a restart into their own goal. (CheckGoal, PunishIndirectKickGoal)
bool goal(Match& match);

/// After a goal the clock runs for three seconds, players are put to where they must stand, and the other
/// team kicks off. (UpdateGoal)
void afterGoal(Match& match, TeamSide scorer);

}  // namespace plumbline::simulation
