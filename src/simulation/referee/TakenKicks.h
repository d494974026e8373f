#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

// What is remembered of the last restart that was taken (rcssserver3d soccerruleaspect.cpp: ResetKickChecks).

/// The player that touched the ball last took a restart.
void kickTaken(Match& match, bool indirect);
/// Nobody has taken a restart, nor is anyone in or after a pass mode.
void forgetKick(Match& match);
/// Whether nobody has touched the ball since the kick of the last restart.
bool stillFromKick(Match& match);

}  // namespace plumbline::simulation
