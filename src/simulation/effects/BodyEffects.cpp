#include "simulation/effects/BodyEffects.h"

#include <algorithm>

#include "simulation/effects/EffectTable.h"

namespace plumbline::simulation {

RobotModel withEffects(RobotModel model, const std::vector<EffectSetting>& effects) {
  constexpr double least = 1e-3;  // [kg]: engines divide by it
  for (const EffectSetting& effect : effects)
    for (Link& link : model.links) {
      if (effect.effect == "link_mass" && isAt(effect, link))
        link.mass = std::max(least, link.mass + effect.value);
      if (effect.effect == "com_offset" && isAt(effect, link)) link.com[effect.axis[0] - 'x'] += effect.value;
      if ((effect.effect == "speed_limit" || effect.effect == "supply_voltage") && isAt(effect, link.joint))
        link.maxSpeed *= effect.value;
    }
  return model;
}

double motorTorque(double nominal, JointId joint, const std::vector<EffectSetting>& effects) {
  double torque = nominal;
  for (const EffectSetting& effect : effects)
    if ((effect.effect == "torque_limit" || effect.effect == "supply_voltage") && isAt(effect, joint))
      torque *= effect.value;
  for (const EffectSetting& effect : effects)
    if (effect.effect == "coulomb_friction" && isAt(effect, joint)) torque -= effect.value;
  return std::max(0.0, torque);
}

}  // namespace plumbline::simulation
