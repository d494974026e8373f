#pragma once
#include <functional>
#include <string>

#include "gap/blind/Draw.h"
#include "gap/blind/Workshop.h"

namespace plumbline::gap {

struct BlindMakeOptions {
  DrawOptions draw;
  std::string robot = "nao_v5";  ///< name in config/robots, or a file
  std::string engine = blindProgram;
  std::string program = "build/SimRelease/bench/mujoco";  ///< of engine program
  std::string output;                                     ///< a new folder
  int jobs = 1;
  std::function<void(std::size_t done)> progress = {};  ///< may throw to stop; called from any thread
};

/// The gap that every effect of a case is given at least, and is held below where that can be done.
constexpr double leastRatio = 3, mostRatio = 100, mostRatioOfHard = 12;

/// Makes a benchmark: OUTPUT/<case>/run1.. and OUTPUT/answers.sealed. Sizes are drawn, then made larger or
/// smaller until the gap that they cause is in range; a place where that cannot be had is drawn anew, and
/// what is reached in the end is kept with its ratio. Same options, same bytes, whatever `jobs` is. Throws
/// std::runtime_error, one line, nothing left behind, where the engine's program is missing or fails.
BlindSet makeBlind(const BlindMakeOptions& options);

/// Severity of the runs in one folder against noise-free nominal ones in another, run by run; the channel
/// that shows it best as "run/channel".
struct Severity {
  double ratio = 0;
  std::string channel;
};
Severity severity(const std::string& folder, const std::string& nominal,
                  const std::vector<std::string>& runs);

}  // namespace plumbline::gap
