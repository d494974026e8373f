#pragma once
#include <optional>
#include <string>

namespace plumbline::bench {

/// Has bin/gap diagnose the runs in a folder, a process of its own that sees nothing else, unless the answer
/// is there; keeps the CPU seconds in a file beside it.
void diagnoseCase(const std::string& runs, const std::string& answer);

/// CPU time that an answer took [s]; nothing where it was made in more than one go.
std::optional<double> secondsOf(const std::string& answer);

}  // namespace plumbline::bench
