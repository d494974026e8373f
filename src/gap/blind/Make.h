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

/// Least gap over noise of every effect of a case, and the largest, if it can be reached.
constexpr double leastRatio = 3, mostRatio = 100, mostRatioOfHard = 12;

/// Makes a benchmark: OUTPUT/<case>/run1.. and OUTPUT/answers.sealed. Sizes are drawn, then made larger or
/// smaller until their gap is in range. If that is impossible at a place, another place is drawn; the last
/// result is kept with its ratio. The same options give the same bytes, whatever `jobs` is. Throws
/// std::runtime_error (one line, nothing left behind) if the engine's program is missing or fails.
BlindSet makeBlind(const BlindMakeOptions& options);

/// Names of cases: numbers that say nothing, each once.
std::vector<std::string> opaqueNames(std::size_t count, std::uint64_t seed);

/// Severity of the runs in one folder compared with noise-free nominal runs in another; `channel` is the one
/// that shows it best, as "run/channel".
struct Severity {
  double ratio = 0;
  std::string channel;
};
Severity severity(const std::string& folder, const std::string& nominal,
                  const std::vector<std::string>& runs);

}  // namespace plumbline::gap
