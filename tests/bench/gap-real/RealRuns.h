#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/inference/Claim.h"
#include "gap/replay/Trial.h"

namespace plumbline::bench {

/// Recordings of one robot that take part in a fit, and those that test it.
struct RealSplit {
  std::string name, what;  ///< id for figures; in words
  std::vector<std::string> fit, test;
  std::map<std::string, std::string> repeats;  ///< of test recordings: the same motion once more
  double fitSeconds = 1e9;                     ///< of each recording for fitting, in segments [s]
};

/// A test recording: root mean square of measured minus simulated position over all joints [rad].
struct TestError {
  std::string run;
  double before = 0, after = 0;
  double floor = 0;       ///< what a repeat differs by, over the square root of two; 0: there is none
  bool repeated = false;  ///< by a recording that is a clean repeat
};

/// `bin/gap diagnose --method`: the usual one of a robot with a fixed base, and the one before it.
enum class Method { sets, blocks };
const char* nameOf(Method method);

/// What came of a split.
struct RealResult {
  gap::Diagnosis diagnosis;
  std::optional<gap::Claim> claim;  ///< of recordings not seen; the sets' alone
  std::vector<TestError> tests;
  double before = 0, after = 0, floor = 0;  ///< over the tests that count [rad]
  double seconds = 0;                       ///< of the processor that the diagnosis took
  double closed() const { return (before - after) / (before - floor); }
};

/// Diagnoses the recordings for fitting, then plays the test recordings' commands on the nominal robot and on
/// the robot with what was found. Where some test recordings have a repeat, those alone count.
/// maxCauses: of blocks; sets have their own limit.
RealResult runSplit(const RealSplit& split, const std::string& robot, const std::string& folder,
                    std::size_t maxCauses, int jobs, Method method);

}  // namespace plumbline::bench
