#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Link angle minus measured angle.
inline const Effect jointOffset{
    .id = "joint_offset",
    .unit = "rad",
    .sites = {Site::joint},
    .lower = -0.3,
    .upper = 0.3,
    .starts = {-0.05, 0.05},
    .linear = true,
    .sentence = "The zero of {at} is wrong: the link stands elsewhere than the encoder says.",
    .exposedBy = "static poses in several postures",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.offset += value; }); },
};

}  // namespace plumbline::gap
