#pragma once
#include <string_view>
#include <vector>

#include "robot/RobotModel.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// Whether two names of a place are the same, whatever the letters' case.
bool samePlace(std::string_view a, std::string_view b);

/// Whether an effect is at a joint, at a link: by name, or "*".
bool isAt(const EffectSetting& setting, JointId joint);
bool isAt(const EffectSetting& setting, const Link& link);

/// Those of a list that are at a joint.
std::vector<EffectSetting> settingsAt(const std::vector<EffectSetting>& settings, JointId joint);

/// 0, 1, 2 for x, y, z.
inline int axisOf(const EffectSetting& setting) { return setting.axis.empty() ? 0 : setting.axis[0] - 'x'; }

/// Of their values.
double sumOf(const std::vector<EffectSetting>& settings);

}  // namespace plumbline::simulation
