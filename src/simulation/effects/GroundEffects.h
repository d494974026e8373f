#pragma once
#include <vector>

#include "simulation/physics/Physics.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// Puts what effects change of the ground into the physics.
void addGroundEffects(const std::vector<EffectSetting>& effects, Material ground, PhysicsConfig& physics);

/// Calls change(surface) for each pair of materials of which one is the ground.
template <typename Change>
void changeGround(Material ground, PhysicsConfig& physics, const Change& change) {
  const auto g = static_cast<std::size_t>(ground);
  for (std::size_t other = 0; other < physics.surfaces.size(); ++other) {
    change(physics.surfaces[g][other]);
    if (other != g) change(physics.surfaces[other][g]);
  }
}

}  // namespace plumbline::simulation
