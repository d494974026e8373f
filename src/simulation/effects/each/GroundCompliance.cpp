#include "simulation/effects/GroundEffects.h"
#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

/// How far the ground gives at each point of contact. A spring k per contact is ERP = h k / (h k + d),
/// CFM = 1 / (h k + d) (ODE manual, "Soft constraints").
const LeagueEffect groundCompliance{
    .id = "ground_compliance",
    .order = 300,
    .site = LeagueEffect::Site::ground,
    .lower = 1e-9,
    .upper = 1e-2,
    .ground =
        [](const EffectSettings& settings, Material ground, PhysicsConfig& physics) {
          changeGround(ground, physics, [&](ContactSurface& surface) {
            surface.softCfm = surface.softErp * settings.back().value / physics.stepSeconds;
          });
        },
};
MAKE_LEAGUE_EFFECT(groundCompliance);

}  // namespace plumbline::simulation
