#pragma once
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Which current a servo without a sign reports: the motor's, or the supply's, which is the duty times the
/// motor's (a shunt before the bridge sees no direction). Sets Signal::ofSupply of unsigned currents to
/// what is likelier of the nominal servo at the measured angles, over all joints and trials; a scale of 1/3
/// to 3 is free. All trials must be of one robot.
void findCurrentSide(std::vector<Trial>& trials);

}  // namespace plumbline::gap
