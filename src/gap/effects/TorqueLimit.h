#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Factor on the largest torque.
inline const Effect torqueLimit{
    .id = "torque_limit",
    .unit = "1",
    .sites = {Site::joint, Site::everywhere},
    .nominal = 1,
    .lower = 0.03,
    .upper = 1.5,
    .starts = {0.15, 0.4, 0.7},
    .reciprocal = true,
    .setting = true,
    .sentence = "The motor of {at} gives less torque than the model's.",
    .exposedBy = "fast moves at the torque limit",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.torqueFactor *= value; }); },
};

}  // namespace plumbline::gap
