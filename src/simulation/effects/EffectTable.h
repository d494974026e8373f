#pragma once
#include <vector>

#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// Refuses effects that the league's robots cannot have: their joints are velocity motors, so they have no
/// effects of position servos. Throws ConfigurationError that names file, line, and the possible effects,
/// places or bounds.
void checkEffects(const std::vector<EffectSetting>& effects);

}  // namespace plumbline::simulation
