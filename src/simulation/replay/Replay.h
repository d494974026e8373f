#pragma once
#include <vector>

#include "robot/RobotModel.h"
#include "simspark/LeagueTrace.h"
#include "simulation/World.h"

namespace plumbline::simulation {

/// Plays a trace's commands open loop in a world of its own, from the state of the trace's first row, and
/// returns what this simulator makes of it: one row for each of the trace's. The velocities of the first row
/// follow from the rows after it and from gyro and accelerometer; the ball is set anew where the trace's ball
/// jumps.
std::vector<simspark::TraceRow> replay(const simspark::LeagueTrace& trace, const RobotModel& model,
                                       const WorldConfig& config = {});

}  // namespace plumbline::simulation
