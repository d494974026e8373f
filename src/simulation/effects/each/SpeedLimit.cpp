#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

/// Factor on the joint's largest speed.
const LeagueEffect speedLimit{
    .id = "speed_limit",
    .order = 60,
    .site = LeagueEffect::Site::jointOrEverywhere,
    .lower = 0,
    .upper = 10,
    .turn = 10,
    .body = [](Link& link, const EffectSetting& setting) { link.maxSpeed *= setting.value; },
};
MAKE_LEAGUE_EFFECT(speedLimit);

}  // namespace plumbline::simulation
