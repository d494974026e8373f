#include <algorithm>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

/// Mass added at the link's centre of mass; a link keeps a gram at least, engines divide by it.
const LeagueEffect linkMass{
    .id = "link_mass",
    .order = 210,
    .site = LeagueEffect::Site::link,
    .lower = -5,
    .upper = 10,
    .body = [](Link& link,
               const EffectSetting& setting) { link.mass = std::max(1e-3, link.mass + setting.value); },
};
MAKE_LEAGUE_EFFECT(linkMass);

}  // namespace plumbline::simulation
