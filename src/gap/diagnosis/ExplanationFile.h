#pragma once
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::gap {

/// The causes that a file of effects names, for one robot. Throws ConfigurationError with file, line and key:
/// an unknown effect, a place that the robot does not have, a value out of bounds.
Explanation causesOf(const std::vector<simulation::EffectSetting>& settings, const Mechanism& robot);

/// The settings for a set of causes.
std::vector<simulation::EffectSetting> settingsOf(const Explanation& causes);

}  // namespace plumbline::gap
