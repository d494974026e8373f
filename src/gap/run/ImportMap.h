#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/ConfigFile.h"
#include "gap/run/Run.h"
#include "gap/run/Table.h"

namespace plumbline::gap {

/// One line of `columns`: a value becomes factor * value + offset.
struct ColumnRule {
  std::string to, from;
  double factor = 1, offset = 0;
  bool unitStated = false;  ///< by unit, scale or counts_per_turn; else it is guessed
  ConfigSection entry;
};

/// What a map says of one recording.
struct RecordingMap {
  TableForm form;
  std::string timeFrom;
  double timeFactor = 1, timeOffset = 0;  ///< offset [s]
  bool timeUnitStated = false;
  std::optional<double> within;  ///< how far a reading may be from its row [s]
  ConfigSection time;
  std::vector<ColumnRule> rules;
};

/// The map of an import (doc/how-to/bring-in-recordings.md).
struct ImportMap {
  ConfigFile file;
  Run head;                                    ///< all but t and channels
  std::map<std::string, std::string> jointOf;  ///< by its name in the recording, for *
  bool severalTables = false;                  ///< it has `tables`
  bool timingStated = false;
  std::vector<RecordingMap> recordings;
};

/// Reads a map. Throws ConfigurationError naming file, line and key.
ImportMap readImportMap(const std::string& path);

}  // namespace plumbline::gap
