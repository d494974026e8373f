#pragma once
#include <string>

#include "gap/replay/Trial.h"
#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// `KIND.* is not used: WHY`
std::string unusedLine(const std::string& column, const std::string& why);

/// A checked run in the form for replay and diagnosis: joints by index, commands without gaps, and the robot
/// with the servo settings of run.json. Channels that the replay cannot predict are left out. Throws RunError
/// if no position of a commanded joint is left.
Trial trialOf(const Run& run, const Mechanism& nominal);

}  // namespace plumbline::gap
