#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

/// Factor on the motor's torque limit.
const LeagueEffect torqueLimit{
    .id = "torque_limit",
    .order = 50,
    .site = LeagueEffect::Site::jointOrEverywhere,
    .lower = 0,
    .upper = 10,
    .turn = 10,
    .torque = [](double torque, double value) { return torque * value; },
};
MAKE_LEAGUE_EFFECT(torqueLimit);

}  // namespace plumbline::simulation
