#pragma once
#include <vector>

#include "gap/settings/Setting.h"
#include "simspark/LeagueTrace.h"

namespace plumbline::gap {

constexpr std::size_t firstRow = 4;  ///< that a replay can begin at: it needs the commands before it
constexpr std::size_t leadRows = 15;

/// Plays a recording's commands from row `first` on in the simulator: what it makes of rows first+1 ..
/// first+count (fewer at the end of the trace). A recording does not have the gaps that load tears into
/// hinges, and they decide when a foot lands. So the simulator begins up to leadRows rows before, and there
/// is put back to the recorded torso and velocities after each row: its hinges gape by themselves as the
/// league's do. The accelerometer is right from the second row returned on. Same arguments, same bytes.
/// Error: std::out_of_range for a row before firstRow or behind the trace.
std::vector<simspark::TraceRow> play(const simspark::LeagueTrace& trace, std::size_t first, std::size_t count,
                                     const SimulatorSetup& setup);

/// The robot of a trace. Error: std::invalid_argument where its name does not say which.
RobotModel robotOf(const simspark::LeagueTrace& trace);

}  // namespace plumbline::gap
