#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

/// Moves a link's centre of mass.
const LeagueEffect comOffset{
    .id = "com_offset",
    .order = 220,
    .site = LeagueEffect::Site::link,
    .axes = "xyz",
    .lower = -0.2,
    .upper = 0.2,
    .body = [](Link& link, const EffectSetting& setting) { link.com[axisOf(setting)] += setting.value; },
};
MAKE_LEAGUE_EFFECT(comOffset);

}  // namespace plumbline::simulation
