#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Of players who touch each other, directly or through others, more than two are too many. The one that came
/// last is called for it, if its team has at least half of them, otherwise one of the opponents; never a
/// goalie. Unless such players go beside the field, it is put 0.4 m away from the others' middle.
/// (AgentCollisionHandler, AnalyseTouchGroups, PenalizeTouchingFoul)
void judgeTouching(Match& match);

}  // namespace plumbline::simulation
