#pragma once
#include <vector>

#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Leaves out speeds, torques and currents that were sent to a joint and that its servo cannot follow, and
/// says why.
void leaveOutUselessCommands(Run& run, const Mechanism::Joint& joint, std::vector<RunWarning>& warnings);

/// Whether a joint was sent speeds, torques or currents.
bool isSentEfforts(const Run& run, const Mechanism::Joint& joint);

}  // namespace plumbline::gap
