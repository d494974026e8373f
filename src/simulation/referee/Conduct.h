#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

// What players do, as the rules about them need it (rcssserver3d soccerruleaspect.cpp:
// CalculateDistanceArrays, ProcessAgentState, ResetFoulCounterPlayer).

/// Clears all counters of the player; it counts as having stood for a while.
void forgive(const Match& match, Participant& player);
/// Takes note of where everybody is, how long they have lain (torso below 0.15 m), not stood (below 0.25 m,
/// until they stood for half a second) or been away from the ball.
void observeConduct(Match& match);
/// Players at the ball have touched it now.
void observeBallTouches(Match& match);
/// The players' velocities of this cycle.
void observeVelocities(Match& match);

}  // namespace plumbline::simulation
