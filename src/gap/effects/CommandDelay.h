#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Transport and processing time between sending a command and its coming into force.
inline const Effect commandDelay{
    .id = "command_delay",
    .unit = "s",
    .sites = {Site::everywhere, Site::joint},
    .lower = 0,
    .upper = 0.2,
    .starts = {0.002, 0.01, 0.03},
    .linear = true,
    .sentence = "Commands reach {at} later than the model says.",
    .exposedBy = "fast moves and steps",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.commandDelay += value; }); },
};

}  // namespace plumbline::gap
