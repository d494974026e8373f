#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// A time-out of a restart, or a trainer's wish. The ball is laid down there, but at its corner if that is in
/// a penalty area, and on the side line if beyond. Everybody within 2 m is put 2.5 m away, and play is on for
/// all. (DropBall)
void dropBall(Match& match, Vec3 place);

}  // namespace plumbline::simulation
