#pragma once
#include <optional>
#include <string>

#include "simulation/world/World.h"

namespace plumbline::simulation {

/// Replays the recording in `file` (a .csv or .csv.gz of simspark/LeagueRecording.h, with the robots recorded
/// with it) and says of each robot how far this simulator is from the league's. `type` is the robot's where
/// the file's name does not say it; a recording of several robots takes none. A std::runtime_error says what
/// is wrong with the file.
std::string replayReport(const std::string& file, std::optional<int> type, const WorldConfig& config = {});

}  // namespace plumbline::simulation
