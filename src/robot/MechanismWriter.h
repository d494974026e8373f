#pragma once
#include <string>

#include "robot/Mechanism.h"

namespace plumbline {

/// The robot as JSON that readMechanism reads (doc/reference/robot-files.md). Frames, which are names for
/// places on a link, and types of servos are not in it; groups are.
std::string mechanismText(const Mechanism& robot);

}  // namespace plumbline
