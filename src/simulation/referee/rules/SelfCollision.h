#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Limbs that go through each other: when two boxes of a robot sink more than 0.04 m into each other, all
/// joints of the arms and legs they belong to take no speed for a second, and for two more seconds cannot be
/// frozen again; the torso has none. A box and the one it hangs on are not looked at. As on the league's
/// server two boxes with an edge of each in the same direction never collide. Each such event is reported as
/// a foul. (AnalyseSelfCollisionFouls, BoxCollider::CheckCollisions, UpdateSelfCollisions)
void judgeSelfCollisions(Match& match);
/// Thaws joints whose second is over; all: whatever the time is.
void thawJoints(Match& match, bool all);

}  // namespace plumbline::simulation
