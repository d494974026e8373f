#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

/// Factor on the voltage that torque and speed limits come from.
const LeagueEffect supplyVoltage{
    .id = "supply_voltage",
    .order = 65,
    .site = LeagueEffect::Site::everywhere,
    .lower = 0,
    .upper = 3,
    .turn = 20,
    .body = [](Link& link, const EffectSetting& setting) { link.maxSpeed *= setting.value; },
    .torque = [](double torque, double value) { return torque * value; },
};
MAKE_LEAGUE_EFFECT(supplyVoltage);

}  // namespace plumbline::simulation
