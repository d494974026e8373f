#pragma once
#include <string>
#include <vector>

#include "gap/run/Run.h"

namespace plumbline::gap {

/// Result of an import from another format.
struct ImportedRun {
  Run run;
  std::vector<std::string> unused;   ///< columns of the recordings that the map does not name
  std::size_t linesWithoutTime = 0;  ///< dropped
  std::vector<std::string> guesses;  ///< units that the map does not name, and what they were taken for
  std::vector<std::string> notes;    ///< how tables were read (Table::notes)
  std::vector<std::string> merged;   ///< of several recordings: how their lines came together
};

struct ImportOptions {
  std::string map;                      ///< file
  std::vector<std::string> recordings;  ///< in the order of the map's tables
  std::string robot;                    ///< name or file, for its limits; empty: the robot that the map names
};

/// Converts tables (csv or csv.gz), JSON lines or bags of ROS 2 (OtherTables.h) to a run. A map says which
/// column becomes which channel, with units, signs, names of joints and scale of time.
/// doc/how-to/bring-in-recordings.md describes the map. Several recordings become one (TableMerge.h). A unit
/// that the map does not name is guessed (UnitGuess.h), except in a bag, which has the units of ROS. Nothing
/// is written. Throws ConfigurationError naming file, line and key of the map, RunError for a recording.
ImportedRun importRecordings(const ImportOptions& options);

/// One recording.
ImportedRun importRecording(const std::string& mapFile, const std::string& recording);

}  // namespace plumbline::gap
