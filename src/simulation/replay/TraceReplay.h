#pragma once
#include <vector>

#include "robot/RobotModel.h"
#include "simspark/LeagueTrace.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// Plays a recording's commands open loop in a world of its own, from the state of the first row, and returns
/// what this simulator makes of it: for each robot one row for each of its trace's. The velocities of the
/// first row follow from the rows after it and from gyro and accelerometer; the ball is set anew where the
/// recording's ball jumps, and a robot is put where a beam or a trainer put it. `models` is as long as
/// `robots`, all traces are of one length (std::invalid_argument).
std::vector<std::vector<simspark::TraceRow>> replay(const std::vector<simspark::LeagueTrace>& robots,
                                                    const std::vector<RobotModel>& models,
                                                    const WorldConfig& config = {});

/// The same for a robot alone.
std::vector<simspark::TraceRow> replay(const simspark::LeagueTrace& trace, const RobotModel& model,
                                       const WorldConfig& config = {});

}  // namespace plumbline::simulation
