#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gap/run/Run.h"

namespace plumbline::gap {

/// The channels of one recording, in the run's units, with the times of its own clock.
struct TimedChannels {
  std::string file;                                     ///< for messages
  std::vector<double> t;                                ///< grows strictly [s]
  std::map<std::string, std::vector<double>> channels;  ///< as long as t; NaN is lost
  /// Largest distance of a reading's time from its row's [s]; absent: half a row.
  std::optional<double> within;
};

/// Several recordings of one motion as one table, with messages for people.
struct MergedChannels {
  std::size_t rowsFrom = 0;  ///< index of the recording whose times are the rows
  std::vector<double> t;
  std::map<std::string, std::vector<double>> channels;
  std::map<std::string, JointTiming> timing;  ///< per joint; empty: nothing to say
  std::vector<std::string> notes;
};

struct MergeOptions {
  bool linearCommands = false;  ///< see Run::linearCommands
  bool timingStated = false;    ///< no timing is derived
};

/// Puts recordings onto the times of the one with positions (of several, the one with most rows in a second).
/// A command is the one in force, the last at or before a row; with linearCommands it is interpolated between
/// two, and lost outside them. A reading is put into the row nearest to it. Each reading has at most one row
/// and each row at most one reading of a column; nothing is interpolated there, and cells without a partner
/// are lost. A constant distance between the times of readings or commands and those of their rows goes into
/// `timing`. Throws RunError: times that do not overlap.
MergedChannels mergeChannels(const std::vector<TimedChannels>& recordings, const MergeOptions& options = {});

}  // namespace plumbline::gap
