#pragma once
#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Refuses a run whose commands leave a joint without any drive: one without a position gain, in the robot's
/// file and in the run, that was sent positions, or nothing that it could use. Throws RunError.
void checkCommands(const Run& run, const Mechanism& robot);

}  // namespace plumbline::gap
