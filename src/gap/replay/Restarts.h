#pragma once
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Time in which a robot settles on its feet after a restart; nothing is compared [s].
constexpr double settling = 0.1;

/// Sets where the replay of a walking robot restarts from the measured state: at its start and about every
/// second, in the middle of a step, when one foot carries nearly the whole weight. So a difference in one
/// landing does not spoil the rest. Also sets in which cycles the robot is between steps. Does nothing with a
/// fixed base, without force sensors, and if the robot does not step: replays in one piece are more
/// informative then.
void cutIntoSteps(Trial& trial);

}  // namespace plumbline::gap
