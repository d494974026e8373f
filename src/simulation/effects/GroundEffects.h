#pragma once
#include <vector>

#include "simulation/physics/Physics.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// Puts ground_friction, ground_compliance (per point of contact) and ground_slope into the physics. The
/// ground stays the plane z = 0 and gravity leans instead, which is the same seen from the ground.
void addGroundEffects(const std::vector<EffectSetting>& effects, Material ground, PhysicsConfig& physics);

}  // namespace plumbline::simulation
