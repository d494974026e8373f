#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Factor on the speed at which the torque has faded to nothing.
inline const Effect speedLimit{
    .id = "speed_limit",
    .unit = "1",
    .sites = {Site::joint, Site::everywhere},
    .nominal = 1,
    .lower = 0.05,
    .upper = 1.5,
    .starts = {0.2, 0.4, 0.7},
    .reciprocal = true,
    .setting = true,
    .sentence = "{at} does not reach the speed that the model allows.",
    .exposedBy = "fast moves near the speed limit",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.maxSpeed *= value; }); },
};

}  // namespace plumbline::gap
