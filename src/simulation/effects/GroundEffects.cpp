#include "simulation/effects/GroundEffects.h"

#include <Eigen/Geometry>

namespace plumbline::simulation {

void addGroundEffects(const std::vector<EffectSetting>& effects, Material ground, PhysicsConfig& physics) {
  const auto onGround = [&](const auto& change) {
    const auto g = static_cast<std::size_t>(ground);
    for (std::size_t other = 0; other < physics.surfaces.size(); ++other) {
      change(physics.surfaces[g][other]);
      if (other != g) change(physics.surfaces[other][g]);
    }
  };
  Vec3 slope = Vec3::Zero();
  for (const EffectSetting& effect : effects) {
    if (effect.effect == "ground_friction")
      onGround([&](ContactSurface& surface) { surface.friction = effect.value; });
    // A spring k per contact is ERP = h k / (h k + d), CFM = 1 / (h k + d) (ODE manual, "Soft constraints").
    if (effect.effect == "ground_compliance")
      onGround([&](ContactSurface& surface) {
        surface.softCfm = surface.softErp * effect.value / physics.stepSeconds;
      });
    if (effect.effect == "ground_slope") slope[effect.axis[0] - 'x'] += effect.value;
  }
  if (const double angle = slope.norm(); angle > 0)
    physics.gravity = Eigen::AngleAxisd(-angle, slope / angle) * physics.gravity;
}

}  // namespace plumbline::simulation
