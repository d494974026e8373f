#pragma once
#include "framework/Config.h"
#include "walking/parameters/WalkGaits.h"

namespace plumbline {

/// The walk's parameters from walking.yaml, which may be overridden for each robot; errors as Config::get.
walking::WalkGaits readWalkGaits(const Config& config);

}  // namespace plumbline
