#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Whether the ball, as a whole, has left the field, and what follows from who touched it last: over the side
/// line a kick-in for the others; behind a goal line a corner kick if its own team was last, else a goal
/// kick. A ball that nobody has touched stays where it is. (CheckBallLeftField)
bool ballOut(Match& match);

}  // namespace plumbline::simulation
