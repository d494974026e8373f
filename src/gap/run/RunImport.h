#pragma once
#include <string>
#include <vector>

#include "gap/run/Run.h"

namespace plumbline::gap {

/// Result of an import from another format.
struct ImportedRun {
  Run run;
  std::vector<std::string> unused;   ///< columns of the recording that the map does not name
  std::size_t linesWithoutTime = 0;  ///< dropped
};

/// Converts a table (csv or csv.gz), JSON lines or a bag of ROS 2 (OtherTables.h) to a run. A map says which
/// column becomes which channel, with units, signs, names of joints and scale of time.
/// doc/how-to/bring-in-recordings.md describes the map. Nothing is written. Throws ConfigurationError naming
/// file, line and key of the map, RunError for the recording.
ImportedRun importRecording(const std::string& mapFile, const std::string& recording);

}  // namespace plumbline::gap
