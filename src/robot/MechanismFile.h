#pragma once
#include <stdexcept>
#include <string>

#include "robot/Mechanism.h"
#include "robot/MechanismCheck.h"

namespace plumbline {

/// A robot's file cannot be used; what() is one line: file, place in it, what is wrong, what to do.
class MechanismError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Reads a robot from a file. It is a `.json` file (the form of config/robots/nao_v5.json), a `.urdf` with
/// its servo table in the same folder (`<stem>.servo.json`, `<stem>.servo.yaml` or `<stem>.servo.yml`), or a
/// `.xml` of MuJoCo, which may have such a table. doc/reference/robot-files.md describes all. Links joined by
/// fixed joints become one. Throws MechanismError, also for unknown keys and impossible values; unlikely
/// values go to `warn`.
Mechanism readMechanism(const std::string& path, const MechanismWarnings& warn = warnOnStandardError);

/// The robot called `name` in a folder of robots (`<name>.json`, else `<name>.urdf`); without a folder that
/// of the configuration (framework/ConfigFolder.h). Throws MechanismError, also for a name that is a path.
Mechanism findMechanism(const std::string& name, const std::string& folder = "");

/// Whether the configuration's robots have a file of that name, good or bad.
bool isKnownMechanism(const std::string& name);

/// A robot by its name in the configuration's robots, or by its file where there is a slash or a dot. Throws
/// MechanismError.
Mechanism namedMechanism(const std::string& nameOrFile);

}  // namespace plumbline
