#include "simulation/effects/GroundEffects.h"
#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

/// The friction coefficient of all that touches the ground.
const LeagueEffect groundFriction{
    .id = "ground_friction",
    .order = 280,
    .site = LeagueEffect::Site::ground,
    .lower = 0,
    .upper = 10,
    .ground =
        [](const EffectSettings& settings, Material ground, PhysicsConfig& physics) {
          changeGround(ground, physics,
                       [&](ContactSurface& surface) { surface.friction = settings.back().value; });
        },
};
MAKE_LEAGUE_EFFECT(groundFriction);

}  // namespace plumbline::simulation
