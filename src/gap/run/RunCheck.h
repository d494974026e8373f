#pragma once
#include <vector>

#include "gap/run/Run.h"
#include "gap/run/RunChanges.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Checks a run with its robot. Channels that cannot be used are removed from run.channels, with an entry in
/// `warnings`; a run that cannot be used at all is refused: RunError. It finds unknown joints (if most are
/// unknown: the wrong robot), times in another unit, commands and positions in degrees, and positions far
/// outside their limits. It also finds a command that was not recorded, a sensor that is stuck or reversed,
/// speeds in degrees or without sign. For inertial and force sensors it finds missing gravity or gravity in
/// g, forces in another unit, and values that no sensor gives. The thresholds are in RunCheck.cpp; they are
/// far beyond what an effect of the library causes.
void checkRun(Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings);

/// readRun, then the changes, then checkRun.
Run readCheckedRun(const std::string& folder, const Mechanism& robot, std::vector<RunWarning>& warnings,
                   const RunChanges& changes = {});

}  // namespace plumbline::gap
