#pragma once
#include <functional>
#include <string>

#include "robot/Mechanism.h"

namespace plumbline {

/// Takes what is implausible about a robot's file: one line each, `FILE: PLACE: WHAT`.
using MechanismWarnings = std::function<void(const std::string&)>;

/// Prints `warning: LINE` on standard error, each line once per process.
void warnOnStandardError(const std::string& line);

/// Checks whether a robot is possible, like MuJoCo's compiler: masses and inertias above its minimum,
/// inertias positive definite and within the triangle inequality, numbers that bodies and motors can have.
/// Throws MechanismError for impossible values. Possible but unlikely values go to `warn`: they mostly have
/// another unit (degrees, millimetres, grams). Both messages name `file`.
void checkMechanism(const Mechanism& mechanism, const std::string& file, const MechanismWarnings& warn);

/// Throws MechanismError, naming the first joint, where one takes no positions (its servo has no gain).
void requirePositionServos(const Mechanism& mechanism);

}  // namespace plumbline
