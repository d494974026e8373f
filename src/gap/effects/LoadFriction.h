#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Dry friction in proportion to the torque that goes through the gear.
inline const Effect loadFriction{
    .id = "load_friction",
    .unit = "1",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.9,
    .starts = {0.05, 0.15, 0.35},
    .sticks = true,
    .ofServo = true,
    .variants = {"load as the motor's torque less what turns the rotor", "load as what reaches the link",
                 "load as the motor's torque"},
    .sentence = "Friction of {at} grows with the load that the gear transmits.",
    .exposedBy = "slow reversals under load",
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          atJoints(plant, place, [value, variant](JointPlant& joint) {
            joint.loadFriction += value;
            joint.loadIs = static_cast<JointPlant::Load>(variant);
          });
        },
};

}  // namespace plumbline::gap
