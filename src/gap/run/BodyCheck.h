#pragma once
#include <vector>

#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// The part of checkRun for gyro, acc, fsr and truth: units, gravity, weight, unit quaternions.
void checkBodySensors(Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings);

}  // namespace plumbline::gap
