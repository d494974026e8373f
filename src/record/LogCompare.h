#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "record/LogCopy.h"

namespace plumbline::record {

/// The first difference of a representation in two logs, and the number of differences.
struct LogDifference {
  std::string thread, representation, field;  ///< the field as `.relative.x`
  std::uint64_t cycle = 0;                    ///< its number
  double time = 0;                            ///< [s]
  std::string left, right;                    ///< the field's values
  std::uint64_t cycles = 0;                   ///< in how many cycles it differs
};

struct LogComparison {
  /// One for each representation that differs, by cycle, within it as the modules were executed.
  std::vector<LogDifference> differences;
  std::uint64_t compared = 0;                 ///< cycles that both have
  std::uint64_t onlyLeft = 0, onlyRight = 0;  ///< cycles that the other lacks
  std::vector<std::string> missing;           ///< lines: what one has and the other lacks
  bool same() const { return differences.empty() && onlyLeft == 0 && onlyRight == 0 && missing.empty(); }
};

/// Compares cycle by cycle, by their numbers. Numbers that differ by no more than `tolerance` are alike.
LogComparison compareLogs(const std::string& left, const std::string& right,
                          const std::vector<std::string>& only, double tolerance,
                          const Progress& progress = {});

}  // namespace plumbline::record
