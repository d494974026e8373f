#pragma once
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Which current a servo without a sign reports: the motor's, or the supply's, which is the duty times the
/// motor's (a shunt before the bridge sees no direction). Sets Signal::ofSupply of unsigned currents to
/// what the nominal servo, at the measured angles, agrees with better over all joints and
/// trials (squared correlation; scales do not matter). All trials must be of one robot.
void findCurrentSide(std::vector<Trial>& trials);

}  // namespace plumbline::gap
