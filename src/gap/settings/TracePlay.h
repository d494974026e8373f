#pragma once
#include <vector>

#include "gap/settings/Setting.h"
#include "simspark/LeagueTrace.h"

namespace plumbline::gap {

constexpr std::size_t firstRow = 4;  ///< first possible row of a replay, which needs the commands before it
constexpr std::size_t leadRows = 15;

/// Plays a recording's commands from row `first` on in the simulator; returns its rows first+1 .. first+count
/// (fewer at the end of the trace). A recording does not contain how far load opens the hinges, but this
/// decides when a foot lands. So the simulator begins up to leadRows rows earlier and is set to the recorded
/// torso and velocities after each of these rows. Its hinges then open by themselves, as the league's do. The
/// accelerometer is right from the second returned row on. The same arguments give the same bytes. Error:
/// std::out_of_range for a row before firstRow or after the end of the trace.
std::vector<simspark::TraceRow> play(const simspark::LeagueTrace& trace, std::size_t first, std::size_t count,
                                     const SimulatorSetup& setup);

/// The robot of a trace. Error: std::invalid_argument if its name does not say which.
RobotModel robotOf(const simspark::LeagueTrace& trace);

}  // namespace plumbline::gap
