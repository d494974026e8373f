#include "simulation/effects/BodyEffects.h"

#include <algorithm>

#include "simulation/effects/EffectPlace.h"
#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

RobotModel withEffects(RobotModel model, const std::vector<EffectSetting>& effects) {
  for (const auto& [effect, settings] : effectsInUse(effects)) {
    if (!effect->body) continue;
    for (const EffectSetting& setting : settings)
      for (Link& link : model.links)
        if (effect->site == LeagueEffect::Site::link ? isAt(setting, link) : isAt(setting, link.joint))
          effect->body(link, setting);
  }
  return model;
}

double motorTorque(double nominal, JointId joint, const std::vector<EffectSetting>& effects) {
  double torque = nominal;
  for (const auto& [effect, settings] : effectsInUse(effects)) {
    if (!effect->torque) continue;
    for (const EffectSetting& setting : settingsAt(settings, joint))
      torque = effect->torque(torque, setting.value);
  }
  return std::max(0.0, torque);
}

}  // namespace plumbline::simulation
