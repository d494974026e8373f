#pragma once
#include "gap/effects/Sizes.h"

namespace plumbline::gap {

/// A spring between motor and link.
inline const Effect jointCompliance{
    .id = "joint_compliance",
    .unit = "rad/(N m)",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.5,
    .starts = {0.005, 0.02, 0.06, 0.2},
    .ofServo = true,
    .variants = {"encoder where the model has it", "encoder on the other side of the gear"},
    .sentence = "The gear of {at} gives way under torque.",
    .exposedBy = "static poses under different loads, chirps",
    .scale = scaleOfCompliance,
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.compliance += value;
            if (variant == 1) joint.linkEncoder = !joint.linkEncoder;
          });
        },
};

}  // namespace plumbline::gap
