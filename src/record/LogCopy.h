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

/// Called now and then with how much is done, 0 to 1.
using Progress = std::function<void(double)>;

/// Writes a part of a log as a log of its own. Returns its number of cycles. Throws std::runtime_error, one
/// line, and leaves nothing behind, if there is no cycle or a name is unknown.
std::uint64_t cutLog(const std::string& path, const std::string& target, const LogPart& part,
                     const Progress& progress = {});

/// Writes logs one behind the other as one. They must have the same threads and representations. Numbers of
/// cycles and times go on: what follows on the log before stays as it is, anything else begins behind a
/// missing cycle. Returns how many cycles are in it.
std::uint64_t joinLogs(const std::vector<std::string>& paths, const std::string& target,
                       const Progress& progress = {});

}  // namespace plumbline::record
