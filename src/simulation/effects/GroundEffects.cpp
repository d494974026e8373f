#include "simulation/effects/GroundEffects.h"

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

void addGroundEffects(const std::vector<EffectSetting>& effects, Material ground, PhysicsConfig& physics) {
  for (const auto& [effect, settings] : effectsInUse(effects))
    if (effect->ground) effect->ground(settings, ground, physics);
}

}  // namespace plumbline::simulation
