#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// The place nearest to where a player is to be moved [m] at which it is in nobody's way; that place
/// itself if there is none among those tried. Counts it as moved into or out of its penalty area.
Vec3 safePlace(Match& match, const Participant& player, const Vec3& wanted, bool avoidBall);

}  // namespace plumbline::simulation
