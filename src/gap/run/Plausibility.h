#pragma once
#include <vector>

#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Warns of what can be but hardly is, and is used as it stands: gains and supplies in run.json that are 0 or
/// far from the robot's, clocks that are far apart, a rate that the times contradict, truth that is promised
/// and not there.
void checkPlausibility(const Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings);

}  // namespace plumbline::gap
