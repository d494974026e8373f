#pragma once
#include "gap/replay/Trial.h"
#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// A checked run as replay and diagnosis want it: joints by index, commands without gaps, the servo settings
/// that run.json gives put into the robot. Channels that nothing here can predict stay out. Throws RunError
/// where no position of a commanded joint is left.
Trial trialOf(const Run& run, const Mechanism& nominal);

}  // namespace plumbline::gap
