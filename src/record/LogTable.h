#pragma once
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "record/LogCopy.h"
#include "record/LogReader.h"

namespace plumbline::record {

/// A column of a log: `BallPos.relative.x`.
struct LogColumn {
  std::size_t topic;
  std::string path;  ///< `.relative.x`; of a list: all its elements are in one cell
  std::string name;
};

/// The columns of a thread below the given names, as `BallPos` or `RobotPose.position.x`; none: all. Throws
/// std::runtime_error for an unknown name, with the nearest one.
std::vector<LogColumn> logColumns(const LogReader& log, const LogReader::Thread& thread,
                                  const std::vector<std::string>& names);

/// Writes a thread as CSV: `time,cycle` and the columns, a line per cycle within the part. Returns the lines
/// without the header.
std::uint64_t writeCsv(LogReader& log, const LogReader::Thread& thread, const std::vector<LogColumn>& columns,
                       const LogPart& part, std::ostream& out, const Progress& progress = {});

}  // namespace plumbline::record
