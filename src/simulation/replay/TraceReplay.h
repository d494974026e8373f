#pragma once
#include <vector>

#include "robot/RobotModel.h"
#include "simspark/LeagueTrace.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// Plays a recording's commands open loop in a separate world, from the state of the first row. Returns for
/// each robot one row of this simulator for each row of its trace. The velocities of the first row follow
/// from the rows after it and from gyro and accelerometer. The ball is set again if the recording's ball
/// jumps, and a robot is put where a beam or a trainer put it. `models` must be as long as `robots`, and all
/// traces must have the same length (std::invalid_argument).
std::vector<std::vector<simspark::TraceRow>> replayTraces(const std::vector<simspark::LeagueTrace>& robots,
                                                          const std::vector<RobotModel>& models,
                                                          const WorldConfig& config = {});

/// The same for a robot alone.
std::vector<simspark::TraceRow> replayTrace(const simspark::LeagueTrace& trace, const RobotModel& model,
                                            const WorldConfig& config = {});

}  // namespace plumbline::simulation
