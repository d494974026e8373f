#pragma once
#include <vector>

#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// Refuses what the league's robots cannot have: their joints are velocity motors without a position servo,
/// so what lives in a servo has no place there. Throws ConfigurationError that names file, line, and what
/// there is: effects, places, bounds.
void checkEffects(const std::vector<EffectSetting>& effects);

}  // namespace plumbline::simulation
