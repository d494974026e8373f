#pragma once
#include <string>
#include <vector>

#include "robot/RobotModel.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// Refuses what the league's robots cannot have: their joints are velocity motors without a position servo,
/// so what lives in a servo has no place there. Throws ConfigurationError that names file, line, and what
/// there is: effects, places, bounds.
void checkEffects(const std::vector<EffectSetting>& effects);

/// Whether an effect is at a joint, at a link: by name, whatever the letters' case, or "*".
bool isAt(const EffectSetting& effect, JointId joint);
bool isAt(const EffectSetting& effect, const Link& link);

}  // namespace plumbline::simulation
