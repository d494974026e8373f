#pragma once
#include <chrono>
#include <string>

#include "framework/CommandLine.h"

namespace plumbline::gap {

/// Adds --timing FILE. The time of a diagnosis is in a separate file, so that the same input gives the same
/// answer, byte for byte.
void addTiming(CommandLine& command, std::string& file);

/// Measures from its construction on.
class Timing {
public:
  /// Writes {"seconds": of real time, "cpu_seconds": of all threads}; empty: nothing. Throws
  /// std::runtime_error.
  void write(const std::string& file) const;

private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace plumbline::gap
