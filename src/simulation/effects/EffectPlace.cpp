#include "simulation/effects/EffectPlace.h"

#include <algorithm>
#include <cctype>

namespace plumbline::simulation {

bool samePlace(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

bool isAt(const EffectSetting& setting, JointId joint) {
  return setting.at == "*" || (joint < numHumanoidJoints && samePlace(setting.at, humanoidJointNames[joint]));
}

bool isAt(const EffectSetting& setting, const Link& link) { return samePlace(setting.at, link.name); }

std::vector<EffectSetting> settingsAt(const std::vector<EffectSetting>& settings, JointId joint) {
  std::vector<EffectSetting> here;
  for (const EffectSetting& setting : settings)
    if (isAt(setting, joint)) here.push_back(setting);
  return here;
}

double sumOf(const std::vector<EffectSetting>& settings) {
  double sum = 0;
  for (const EffectSetting& setting : settings) sum += setting.value;
  return sum;
}

}  // namespace plumbline::simulation
