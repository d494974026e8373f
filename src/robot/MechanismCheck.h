#pragma once
#include <functional>
#include <string>

#include "robot/Mechanism.h"

namespace plumbline {

/// Takes what is implausible about a robot's file: one line each, `FILE: PLACE: WHAT`.
using MechanismWarnings = std::function<void(const std::string&)>;

/// Prints `warning: LINE` on standard error, each line once per process.
void warnOnStandardError(const std::string& line);

/// Whether a robot can be, as MuJoCo's compiler checks it: masses and inertias above its minimum, inertias
/// positive definite and within the triangle inequality, numbers within what bodies and motors have. Throws
/// MechanismError for what cannot be. What can be and is far from every robot known goes to `warn`: such
/// numbers mostly have another unit (degrees, millimetres, grams). `file` stands in both.
void checkMechanism(const Mechanism& mechanism, const std::string& file, const MechanismWarnings& warn);

}  // namespace plumbline
