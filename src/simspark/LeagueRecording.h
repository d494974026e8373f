#pragma once
#include <filesystem>
#include <vector>

#include "simspark/LeagueTrace.h"

namespace plumbline::simspark {

/// The traces of all robots of the recording that this file belongs to, in the order of their numbers. Of
/// several robots each has a file of its own in one folder: NAME_r1t0.csv.gz, NAME_r2t3.csv.gz (robot 2, of
/// type 3); NAME.csv.gz is robot 1, too. Any of them names the recording.
/// Errors: those of readLeagueTrace; std::runtime_error for two files of one robot or of another length.
std::vector<LeagueTrace> readLeagueRecording(const std::filesystem::path& file);

}  // namespace plumbline::simspark
