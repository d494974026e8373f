#pragma once
#include <string>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// The robot of a --robot option: a file's path, or a name in config/robots; if nothing is given, the
/// robot called `named`. Throws MechanismError.
Mechanism robotOf(const std::string& given, const std::string& named);

}  // namespace plumbline::gap
