#pragma once
#include <vector>

#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Warns about values that are possible but unlikely; they are used unchanged. These are gains and supplies
/// in run.json that are 0 or far from the robot's, clocks that are far apart, a rate that the times
/// contradict, and missing truth columns.
void checkPlausibility(const Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings);

}  // namespace plumbline::gap
