#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

// Restarts given to a side: their play mode and place. The ball is laid down there after the pause
// (Restart.h).

/// A metre before the middle of the side's own goal.
void awardGoalKick(Match& match, TeamSide side);
/// At the opponents' goal line, halfway between the middle of the goal's half and the corner, on the side
/// where the ball is: y = (20 + 2.1) / 4 - 0.042.
void awardCornerKick(Match& match, TeamSide side);
/// At the side line, where the ball was last on the field.
void awardKickIn(Match& match, TeamSide side);
/// Where the ball was last on the field.
void awardFreeKick(Match& match, TeamSide side, bool indirect);

}  // namespace plumbline::simulation
