#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

/// For a velocity motor, friction is torque that it lacks, whatever its limit is.
const LeagueEffect coulombFriction{
    .id = "coulomb_friction",
    .order = 70,
    .lower = 0,
    .upper = 10,
    .turn = 30,
    .torque = [](double torque, double value) { return torque - value; },
};
MAKE_LEAGUE_EFFECT(coulombFriction);

}  // namespace plumbline::simulation
