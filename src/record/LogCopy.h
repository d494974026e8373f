#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace plumbline::record {

/// Which part of a log is wanted.
struct LogPart {
  double from = 0, to = 9e9;  ///< [s] of the log's time, both within
  std::uint64_t firstCycle = 0,
                lastCycle = std::numeric_limits<std::uint64_t>::max();  ///< numbers, both within
  std::vector<std::string> only{};                                      ///< representations; empty: all
};

/// Called now and then with the share done, 0 to 1.
using Progress = std::function<void(double)>;

/// Writes a part of a log as a log of its own. Returns its number of cycles. Throws std::runtime_error, one
/// line, and leaves nothing behind, if there is no cycle or a name is unknown.
std::uint64_t cutLog(const std::string& path, const std::string& target, const LogPart& part,
                     const Progress& progress = {});

/// Appends logs to each other as one. They must have the same threads and representations. Numbers of
/// cycles and times continue: a log that follows the one before stays as it is, any other starts after a
/// missing cycle. Returns the number of cycles.
std::uint64_t joinLogs(const std::vector<std::string>& paths, const std::string& target,
                       const Progress& progress = {});

}  // namespace plumbline::record
