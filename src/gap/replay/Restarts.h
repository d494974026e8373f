#pragma once
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// How long after a restart a robot comes to rest on its feet; nothing is compared [s].
constexpr double settling = 0.1;

/// Where the replay of a robot that steps goes on from what was measured: at its start and about every
/// second, then in the middle of a step, when one foot carries nearly everything. So what differs in one
/// landing does not spoil the rest. Also says in which cycles it is between steps. Does nothing with a fixed
/// base, without force sensors, and where a robot stays on its feet: replays in one piece say more about
/// those.
void cutIntoSteps(Trial& trial);

}  // namespace plumbline::gap
