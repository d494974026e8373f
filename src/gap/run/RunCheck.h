#pragma once
#include <vector>

#include "gap/run/Run.h"
#include "gap/run/RunChanges.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Holds a run against its robot. What no verdict may rest on is taken out of run.channels and said in
/// `warnings`; a run that is of no use as a whole is refused: RunError. Looked for are joints the robot lacks
/// (most of them: the wrong robot), times in another unit, commands and positions in degrees, and positions
/// far outside their limits. Further: a command that was not recorded, a sensor that is stuck or turned
/// round, speeds in degrees or without sign. At the inertial and force sensors: gravity missing or in g,
/// forces in another unit, values that no sensor gives. The thresholds stand in RunCheck.cpp; all are far
/// from what an effect of the library does.
void checkRun(Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings);

/// readRun and checkRun in one, with the changes put in between.
Run readCheckedRun(const std::string& folder, const Mechanism& robot, std::vector<RunWarning>& warnings,
                   const RunChanges& changes = {});

}  // namespace plumbline::gap
