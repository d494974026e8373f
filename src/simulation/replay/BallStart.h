#pragma once
#include "simspark/LeagueTrace.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// Whether somebody moved the ball in the step to this row: farther than it can roll.
bool ballJumps(const simspark::LeagueTrace& trace, std::size_t row);

/// The state of the ball one step before this row that explains this row and the next ones best. It has no
/// spin, as when a trainer sets it (Gauss-Newton over up to 10 rows; over 2 if something else touches the
/// ball).
BodyState ballBefore(const simspark::LeagueTrace& trace, std::size_t row, const WorldConfig& config);

/// The same ball a step later, alone on the field.
BodyState ballAfterOneStep(const BodyState& before, const WorldConfig& config);

}  // namespace plumbline::simulation
