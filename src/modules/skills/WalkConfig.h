#pragma once
#include "framework/Config.h"
#include "modules/skills/WalkToPose.h"

namespace plumbline {

/// Reads the parameters of walkToPose from a module's configuration; errors as Config::get.
WalkToPoseParameters readWalkToPose(const Config& config);

}  // namespace plumbline
