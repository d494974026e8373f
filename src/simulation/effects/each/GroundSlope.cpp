#include <Eigen/Geometry>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

/// Angle by which the ground is turned about a horizontal axis.
const LeagueEffect groundSlope{
    .id = "ground_slope",
    .order = 290,
    .site = LeagueEffect::Site::ground,
    .axes = "xy",
    .lower = -0.5,
    .upper = 0.5,
    .ground =
        [](const EffectSettings& settings, Material, PhysicsConfig& physics) {
          Vec3 slope = Vec3::Zero();
          for (const EffectSetting& setting : settings) slope[axisOf(setting)] += setting.value;
          if (const double angle = slope.norm(); angle > 0)
            physics.gravity = Eigen::AngleAxisd(-angle, slope / angle) * physics.gravity;
        },
};
MAKE_LEAGUE_EFFECT(groundSlope);

}  // namespace plumbline::simulation
