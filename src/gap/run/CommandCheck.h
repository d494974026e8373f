#pragma once
#include <string>
#include <vector>

#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Leaves out speeds, torques and currents that were sent to a joint and that its servo cannot follow, and
/// says why. joint: with the gains of the run (withServo).
void leaveOutUselessCommands(Run& run, const Mechanism::Joint& joint, std::vector<RunWarning>& warnings);

/// Whether a joint was sent speeds, torques or currents.
bool wasSentSpeedOrTorque(const Run& run, const std::string& joint);

/// Refuses a run whose commands leave a joint without any drive: one without a position gain, in the robot's
/// file and in the run, that was sent positions, or nothing that it could use. Throws RunError.
void checkCommands(const Run& run, const Mechanism& robot);

}  // namespace plumbline::gap
